#include "simulators/usb/exposed_device.h"

#include <gtest/gtest.h>

#include <atomic>
#include <deque>

namespace foverig::usb {
namespace {

/// Gives what the test put in, one outcome a call.
class ScriptedTransport final : public Transport {
  public:
    NextPacket next(HostTime) override {
        if (script.empty()) return Timeout{};
        NextPacket next = std::move(script.front());
        script.pop_front();
        return next;
    }
    Status control_set(std::uint8_t, std::uint16_t, std::span<const std::byte>) override {
        return Done{};
    }
    Result<std::vector<std::byte>> control_get(std::uint8_t, std::uint16_t, std::size_t) override {
        return Error{ErrorCode::unsupported, "none"};
    }
    std::deque<NextPacket> script;
};

/// What happened to the faces, in order: '+' plugged in, '-' unplugged, a packet's first byte.
struct Log {
    std::mutex mutex;
    std::string text;
    void add(char what) {
        const std::lock_guard lock(mutex);
        text += what;
    }
};

class LoggedFace final : public Face {
  public:
    LoggedFace(Log& log, const std::atomic<bool>& connected) : log_(log), connected_(connected) {
        log.add('+');
    }
    ~LoggedFace() override { log_.add('-'); }
    void send(std::vector<std::byte> packet) override {
        log_.add(static_cast<char>(packet.front()));
        unheard_ += packet.front() == std::byte{'u'} ? 1 : 0;
    }
    bool connected() const override { return connected_; }
    std::uint64_t unheard() const override { return unheard_; }

  private:
    std::uint64_t unheard_ = 0;
    Log& log_;
    const std::atomic<bool>& connected_;
};

class ExposedDeviceTest : public testing::Test {
  protected:
    NextPacket packet(char first) {
        return Packet{HostTime{}, std::vector{static_cast<std::byte>(first), std::byte{0}}};
    }
    NextPacket unplugged() { return Fault{Error{ErrorCode::closed, "unplugged"}}; }
    PlugIn plug_in() {
        return [this] { return std::unique_ptr<Face>(new LoggedFace(log, connected)); };
    }
    std::unique_ptr<ExposedDevice> begin() {
        auto begun = ExposedDevice::begin(locked, clock, plug_in());
        EXPECT_TRUE(begun);
        return std::move(begun).value();
    }
    void wait_for_end(const ExposedDevice& device) {
        while (!device.ended()) std::this_thread::yield();
    }

    WallClock clock;
    ScriptedTransport model;
    LockedTransport locked{model};
    Log log;
    std::atomic<bool> connected{true};
};

TEST_F(ExposedDeviceTest, PassesPacketsOnInOrderUntilTheModelEnds) {
    for (const char c : std::string("abc")) model.script.push_back(packet(c));
    model.script.emplace_back(Timeout{});
    model.script.push_back(packet('d'));
    model.script.emplace_back(EndOfStream{});
    auto device = begin();
    wait_for_end(*device);
    EXPECT_EQ(device->counts().packets, 4u);
    device.reset();
    EXPECT_EQ(log.text, "+abcd-");
}

TEST_F(ExposedDeviceTest, UnplugsAndPlugsInWithTheModel) {
    model.script.push_back(packet('a'));
    model.script.push_back(unplugged());
    model.script.push_back(unplugged());
    model.script.emplace_back(Timeout{});
    model.script.push_back(packet('b'));
    model.script.push_back(unplugged());
    model.script.push_back(packet('c'));  // back before the model had nothing to say
    model.script.emplace_back(EndOfStream{});
    auto device = begin();
    wait_for_end(*device);
    EXPECT_EQ(device->counts().plugged_in, 3u);
    device.reset();
    EXPECT_EQ(log.text, "+a-+b-+c-");
}

TEST_F(ExposedDeviceTest, CountsWhatNobodyHeardOverEveryReplug) {
    for (const char c : std::string("uau")) model.script.push_back(packet(c));
    model.script.push_back(unplugged());
    for (const char c : std::string("au")) model.script.push_back(packet(c));
    model.script.push_back(unplugged());
    model.script.push_back(packet('a'));
    model.script.emplace_back(EndOfStream{});
    const auto device = begin();
    wait_for_end(*device);
    EXPECT_EQ(device->counts().plugged_in, 3u);
    EXPECT_EQ(device->counts().unheard, 3u);
}

TEST_F(ExposedDeviceTest, EndsWhereTheKernelLetsGo) {
    auto device = begin();
    EXPECT_FALSE(device->ended());
    connected = false;
    wait_for_end(*device);
    EXPECT_FALSE(device->error());
}

TEST_F(ExposedDeviceTest, SaysWhyItCannotBePluggedIn) {
    const auto refuse = [] {
        return Result<std::unique_ptr<Face>>(Error{ErrorCode::forbidden, "no"});
    };
    const auto begun = ExposedDevice::begin(locked, clock, refuse);
    ASSERT_FALSE(begun);
    EXPECT_EQ(begun.error().code, ErrorCode::forbidden);
}

}  // namespace
}  // namespace foverig::usb
