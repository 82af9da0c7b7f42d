#include "devices/hardware/live_transport.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <stdexcept>
#include <thread>

#include "devices/hardware/open_devices.h"

namespace foverig::hardware {
namespace {

Bytes bytes_of(const std::vector<std::byte>& v) {
    return v;
}
const std::vector<std::byte> kFirst{std::byte{1}}, kSecond{std::byte{2}};

HostTime at_ms(int ms) {
    return HostTime(Nanoseconds(std::int64_t{ms} * 1'000'000));
}

std::vector<std::byte> packet_of(const NextPacket& next) {
    const auto* packet = std::get_if<Packet>(&next);
    return packet != nullptr ? to_vector(packet->bytes) : std::vector<std::byte>{};
}

TEST(PacketQueue, GivesWhatArrivedByTheDeadlineInOrder) {
    ManualClock clock;
    PacketQueue queue(clock);
    clock.sleep_until(at_ms(1));
    queue.push(bytes_of(kFirst));
    clock.sleep_until(at_ms(3));
    queue.push(bytes_of(kSecond));
    EXPECT_EQ(packet_of(queue.next(at_ms(2))), kFirst);
    EXPECT_TRUE(std::holds_alternative<Timeout>(queue.next(at_ms(2))));
    EXPECT_EQ(packet_of(queue.next(at_ms(3))), kSecond);
    EXPECT_TRUE(std::holds_alternative<Timeout>(queue.next(at_ms(3))));
}

TEST(PacketQueue, TellsOfALossEvenWhenTheDeviceIsBack) {
    ManualClock clock;
    PacketQueue queue(clock);
    queue.push(bytes_of(kFirst));
    queue.lost({ErrorCode::closed, "unplugged"});
    queue.lost({ErrorCode::not_found, "still unplugged"});
    queue.found();
    queue.push(bytes_of(kSecond));
    EXPECT_EQ(packet_of(queue.next(at_ms(0))), kFirst);
    EXPECT_TRUE(std::holds_alternative<Fault>(queue.next(at_ms(0))));
    EXPECT_EQ(packet_of(queue.next(at_ms(0))), kSecond);
    EXPECT_TRUE(std::holds_alternative<Timeout>(queue.next(at_ms(0))));
}

TEST(PacketQueue, IsFaultyUntilTheDeviceIsFound) {
    ManualClock clock;
    PacketQueue queue(clock);
    queue.lost({ErrorCode::closed, "unplugged"});
    for (int i = 0; i < 3; ++i) {
        EXPECT_TRUE(std::holds_alternative<Fault>(queue.next(at_ms(0))));
    }
    queue.found();
    EXPECT_TRUE(std::holds_alternative<Timeout>(queue.next(at_ms(0))));
}

TEST(PacketQueue, KeepsTheNewestWhenNobodyAsks) {
    ManualClock clock;
    PacketQueue queue(clock);
    queue.push(bytes_of(kFirst));
    for (std::size_t i = 0; i < PacketQueue::kCapacity; ++i) queue.push(bytes_of(kSecond));
    EXPECT_EQ(packet_of(queue.next(at_ms(0))), kSecond);
}

TEST(PacketQueue, KeepsToItsRoomHoweverOftenTheDeviceIsLost) {
    ManualClock clock;
    PacketQueue queue(clock, 4);
    for (int i = 0; i < 1000; ++i) {
        queue.push(bytes_of(kFirst));
        queue.lost({ErrorCode::closed, "unplugged"});
        queue.found();
    }
    int told = 0;
    while (!std::holds_alternative<Timeout>(queue.next(at_ms(0)))) ++told;
    EXPECT_LE(told, 5);
}

TEST(PacketQueue, TellsOfALossThatGaveWayToPackets) {
    ManualClock clock;
    PacketQueue queue(clock, 4);
    queue.lost({ErrorCode::closed, "unplugged"});
    queue.found();
    for (int i = 0; i < 9; ++i) queue.push(bytes_of(kSecond));
    EXPECT_TRUE(std::holds_alternative<Fault>(queue.next(at_ms(0))));
    for (int i = 0; i < 4; ++i) EXPECT_EQ(packet_of(queue.next(at_ms(0))), kSecond);
    EXPECT_TRUE(std::holds_alternative<Timeout>(queue.next(at_ms(0))));
}

/// A frame of a run that took two seconds, as one that compiles a scene or waits for a disk may.
TEST(PacketQueue, HoldsTheTrackerCamerasFramesOverASlowFrame) {
    ManualClock clock;
    PacketQueue queue(clock, kTrackerFrames);
    const std::vector<std::byte> frame(752 * 480);
    for (std::uint8_t i = 0; i < 120; ++i) queue.push(std::array{std::byte{i}}, frame);
    for (std::uint8_t i = 0; i < 120; ++i) {
        const auto next = queue.next(at_ms(0));
        ASSERT_EQ(std::get<Packet>(next).bytes[0], std::byte{i});
    }
}

/// Gives two packets, then is gone.
class ShortLink final : public Link {
  public:
    explicit ShortLink(std::atomic<int>* keep_awakes = nullptr) : keep_awakes_(keep_awakes) {}
    Status read(PacketQueue& packets) override {
        if (++reads_ > 2) return Error{ErrorCode::closed, "gone"};
        packets.push(kFirst);
        return Done{};
    }
    Status control_set(std::uint8_t, std::uint16_t, Bytes) override { return Done{}; }
    Result<std::vector<std::byte>> control_get(std::uint8_t, std::uint16_t, std::size_t) override {
        return kSecond;
    }
    void keep_awake(std::uint8_t id, Bytes data, Nanoseconds period) override {
        if (id == 17 && data.size() == 1 && period == Nanoseconds(3)) ++*keep_awakes_;
    }

  private:
    std::atomic<int>* keep_awakes_;
    int reads_ = 0;
};

TEST(LiveTransport, OpensItsDeviceAgainAndAgain) {
    const WallClock clock;
    std::atomic<int> opened = 0;
    const auto open = [&]() -> Result<std::unique_ptr<Link>> {
        if (++opened % 2 == 0) return Error{ErrorCode::not_found, "not yet"};
        return std::unique_ptr<Link>(new ShortLink);
    };
    const auto transport = LiveTransport::open(
        clock, open, {.retry_period = Nanoseconds(1'000'000), .realtime = false});
    ASSERT_TRUE(transport);
    const HostTime deadline = clock.now() + Nanoseconds(10'000'000'000);
    int packets = 0, losses = 0;
    bool up = true;
    while (packets < 6 && clock.now() < deadline) {
        const auto next = (*transport)->next(deadline);
        if (std::holds_alternative<Packet>(next)) ++packets;
        const bool fault = std::holds_alternative<Fault>(next);
        losses += up && fault ? 1 : 0;
        up = !fault;
    }
    EXPECT_EQ(packets, 6);
    EXPECT_EQ(losses, 2);
}

/// Asked once; each link that is opened later is told.
TEST(LiveTransport, KeepsWhatComesBackAwake) {
    const WallClock clock;
    std::atomic<int> keep_awakes = 0;
    const auto open = [&]() -> Result<std::unique_ptr<Link>> {
        return std::unique_ptr<Link>(new ShortLink(&keep_awakes));
    };
    const auto transport = LiveTransport::open(
        clock, open, {.retry_period = Nanoseconds(1'000'000), .realtime = false});
    ASSERT_TRUE(transport);
    (*transport)->keep_awake(17, kFirst, Nanoseconds(3));
    const HostTime deadline = clock.now() + Nanoseconds(10'000'000'000);
    while (keep_awakes < 4 && clock.now() < deadline) (void)(*transport)->next(clock.now());
    EXPECT_GE(keep_awakes, 4);
}

/// Can be opened, but fails with the first thing that is asked of it.
class BrokenLink final : public Link {
  public:
    Status read(PacketQueue&) override { return Error{ErrorCode::io, "broken"}; }
    Status control_set(std::uint8_t, std::uint16_t, Bytes) override { return Done{}; }
    Result<std::vector<std::byte>> control_get(std::uint8_t, std::uint16_t, std::size_t) override {
        return kSecond;
    }
};

TEST(LiveTransport, LeavesADeviceThatFailsAtOnceInPeaceForAWhile) {
    const WallClock clock;
    const Nanoseconds period(5'000'000);
    std::atomic<int> opened = 0;
    const auto open = [&]() -> Result<std::unique_ptr<Link>> {
        ++opened;
        return std::unique_ptr<Link>(new BrokenLink);
    };
    const HostTime start = clock.now();
    const auto transport =
        LiveTransport::open(clock, open, {.retry_period = period, .realtime = false});
    ASSERT_TRUE(transport);
    while (opened < 8 && clock.now() < start + Nanoseconds(10'000'000'000))
        (void)(*transport)->next(clock.now());
    EXPECT_GE(opened, 8);
    EXPECT_GE(clock.now() - start, 7 * period);
}

TEST(LiveTransport, OutlivesASearchThatThrows) {
    const WallClock clock;
    std::atomic<int> opened = 0;
    const auto open = [&]() -> Result<std::unique_ptr<Link>> {
        if (++opened == 2) throw std::runtime_error("a folder of sysfs is gone");
        return std::unique_ptr<Link>(new ShortLink);
    };
    const auto transport = LiveTransport::open(
        clock, open, {.retry_period = Nanoseconds(1'000'000), .realtime = false});
    ASSERT_TRUE(transport);
    const HostTime deadline = clock.now() + Nanoseconds(10'000'000'000);
    while (opened < 3 && clock.now() < deadline) (void)(*transport)->next(clock.now());
    EXPECT_GE(opened, 3);
}

/// Real time, and what links say that they took of it.
class SteppedClock final : public Clock {
  public:
    HostTime now() const override { return clock_.now() + Nanoseconds(stepped_.load()); }
    void sleep_until(HostTime) override {}
    void step(Nanoseconds by) { stepped_ += by.count(); }

  private:
    WallClock clock_;
    std::atomic<std::int64_t> stepped_ = 0;
};

/// Streams nothing, and refuses each request after a while.
class SulkingLink final : public Link {
  public:
    SulkingLink(SteppedClock& clock, Nanoseconds takes, std::atomic<int>& asked)
        : clock_(clock), takes_(takes), asked_(asked) {}
    Status read(PacketQueue&) override {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return Done{};
    }
    Status control_set(std::uint8_t, std::uint16_t, Bytes) override { return refuse(); }
    Result<std::vector<std::byte>> control_get(std::uint8_t, std::uint16_t, std::size_t) override {
        return refuse();
    }

  private:
    Error refuse() {
        ++asked_;
        clock_.step(takes_);
        return {ErrorCode::io, "timed out"};
    }

    SteppedClock& clock_;
    Nanoseconds takes_;
    std::atomic<int>& asked_;
};

/// Of 100 s in which a caller asks four times a second.
int requests_made(Nanoseconds each_takes) {
    SteppedClock clock;
    std::atomic<int> asked = 0;
    const auto open = [&]() -> Result<std::unique_ptr<Link>> {
        return std::unique_ptr<Link>(new SulkingLink(clock, each_takes, asked));
    };
    const auto transport = LiveTransport::open(clock, open, {.realtime = false});
    if (!transport) return -1;
    const HostTime start = clock.now();
    for (int i = 0; clock.now() < start + Nanoseconds(100'000'000'000); ++i) {
        if (i % 2 == 0) {
            EXPECT_FALSE((*transport)->control_get(3, 0, 16));
        } else {
            EXPECT_FALSE((*transport)->control_set(3, 0, {}));
        }
        clock.step(Nanoseconds(250'000'000));
    }
    return asked;
}

TEST(LiveTransport, AsksADeviceThatLetsRequestsRunOutOfTimeAtMostATwentiethOfTheTime) {
    // Of a second each: at 0, 2 and 7 s, then each 20; of five: at 0, 10 and 35 s, then at 135.
    const int of_a_second = requests_made(Nanoseconds(1'000'000'000));
    EXPECT_GE(of_a_second, 7);
    EXPECT_LE(of_a_second, 8);
    EXPECT_EQ(requests_made(Nanoseconds(5'000'000'000)), 3);
}

TEST(LiveTransport, SaysOfARequestThatItDidNotSendIt) {
    SteppedClock clock;
    std::atomic<int> asked = 0;
    const auto open = [&]() -> Result<std::unique_ptr<Link>> {
        return std::unique_ptr<Link>(new SulkingLink(clock, Nanoseconds(1'000'000'000), asked));
    };
    const auto transport = LiveTransport::open(clock, open, {.realtime = false});
    ASSERT_TRUE(transport);
    EXPECT_EQ((*transport)->control_get(3, 0, 16).error().code, ErrorCode::io);
    EXPECT_EQ((*transport)->control_get(3, 0, 16).error().code, ErrorCode::not_asked);
    EXPECT_EQ((*transport)->control_set(3, 0, {}).error().code, ErrorCode::not_asked);
    EXPECT_EQ(asked, 1);
}

TEST(LiveTransport, AsksADeviceThatRefusesAtOnceAgain) {
    EXPECT_GT(requests_made(Nanoseconds(1'000'000)), 380);
}

TEST(LiveTransport, SaysWhyItCannotOpen) {
    const WallClock clock;
    const auto transport = LiveTransport::open(
        clock,
        [] {
            return Result<std::unique_ptr<Link>>(Error{ErrorCode::busy, "held"});
        },
        {});
    ASSERT_FALSE(transport);
    EXPECT_EQ(transport.error().code, ErrorCode::busy);
}

}  // namespace
}  // namespace foverig::hardware
