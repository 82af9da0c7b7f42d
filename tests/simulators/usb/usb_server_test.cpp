// The server's side of the socket, with the test as the kernel.
#include "simulators/usb/usb_server.h"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include "simulators/usb/descriptors.h"
#include "tests/devices/byte_text.h"

namespace foverig::usb {
namespace {

using test::bytes_of;

/// Answers vendor request 1 with its value, stalls otherwise.
class EchoFunction final : public UsbFunction {
  public:
    const Descriptors& descriptors() const override { return descriptors_; }
    std::optional<std::vector<std::byte>> answer(const Setup& setup) override {
        if (setup.request != 1) return std::nullopt;
        return usb::bytes_of({setup.value & 0xFFU, static_cast<unsigned>(setup.value) >> 8U, 0, 0});
    }
    bool take(const Setup& setup, Bytes data) override {
        taken = to_vector(data);
        return setup.request == 1;
    }
    std::vector<std::byte> taken;

  private:
    Descriptors descriptors_{.device = device_descriptor({.vendor = 1, .product = 2}),
                             .configuration = {},
                             .strings = {"a", "b", "c"}};
};

class Host {
  public:
    Host() {
        int ends[2] = {-1, -1};
        EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
        socket_ = FileHandle(ends[0]);
        server.emplace(FileHandle(ends[1]), function, clock);
    }
    void write(std::initializer_list<std::uint32_t> words, Bytes rest = {}) {
        std::vector<std::byte> message;
        for (const std::uint32_t word : words) {
            for (int shift = 24; shift >= 0; shift -= 8) {
                message.push_back(static_cast<std::byte>(word >> shift & 0xFFU));
            }
        }
        message.insert(message.end(), rest.begin(), rest.end());
        EXPECT_EQ(::send(socket_.get(), message.data(), message.size(), MSG_NOSIGNAL),
                  static_cast<ssize_t>(message.size()));
    }
    /// A transfer from IN endpoint `endpoint`, with a setup of 8 bytes for endpoint 0.
    void ask(std::uint32_t sequence, std::uint32_t endpoint, std::uint32_t length,
             const char* setup = "0000000000000000") {
        write({1, sequence, 0x10001, 1, endpoint, 0, length, 0, 0, 0}, bytes_of(setup));
    }
    void unlink(std::uint32_t sequence, std::uint32_t victim) {
        write({2, sequence, 0x10001, 0, 0, victim, 0, 0, 0, 0, 0, 0});
    }
    std::vector<std::byte> read(std::size_t size) {
        std::vector<std::byte> bytes(size);
        const auto got = ::recv(socket_.get(), bytes.data(), size, MSG_WAITALL);
        bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
        return bytes;
    }
    struct Answer {
        std::uint32_t command, sequence, status, length;
        bool operator==(const Answer&) const = default;
    };
    Answer answer() {
        const auto header = read(kHeaderSize);
        if (header.size() != kHeaderSize) return {};
        const auto word = [&](std::size_t i) {
            std::uint32_t value = 0;
            for (std::size_t k = 0; k < 4; ++k) value = value << 8U | read_u8(header, 4 * i + k);
            return value;
        };
        return {word(0), word(1), word(5), word(6)};
    }
    void hang_up() { socket_ = FileHandle(); }

    WallClock clock;
    EchoFunction function;
    std::optional<UsbServer> server;

  private:
    FileHandle socket_;
};

constexpr auto kErrno = [](int value) { return static_cast<std::uint32_t>(value); };

TEST(UsbServer, AnswersControlRequests) {
    Host host;
    host.ask(1, 0, 18, "8006000100001200");
    EXPECT_EQ(host.answer(), (Host::Answer{3, 1, 0, 18}));
    EXPECT_EQ(host.read(18), host.function.descriptors().device);
    host.ask(2, 0, 2, "c001341200000400");  // less room than wLength says
    EXPECT_EQ(host.answer(), (Host::Answer{3, 2, 0, 2}));
    EXPECT_EQ(host.read(2), bytes_of("3412"));
}

TEST(UsbServer, StallsAsBrokenPipe) {
    Host host;
    host.ask(1, 0, 4, "c007000000000400");
    EXPECT_EQ(host.answer(), (Host::Answer{3, 1, kErrno(-32), 0}));
    host.write({1, 2, 0x10001, 0, 2, 0, 3, 0, 0, 0, 0, 0}, bytes_of("010203"));
    EXPECT_EQ(host.answer(), (Host::Answer{3, 2, kErrno(-32), 0})) << "no OUT endpoint";
}

TEST(UsbServer, TakesTheDataOfAControlRequest) {
    Host host;
    host.write({1, 1, 0x10001, 0, 0, 0, 3, 0, 0, 0}, bytes_of("4001000000000300 aabbcc"));
    EXPECT_EQ(host.answer(), (Host::Answer{3, 1, 0, 3}));
    EXPECT_EQ(host.function.taken, bytes_of("aabbcc"));
}

TEST(UsbServer, GivesPacketsInOrderToWaitingTransfers) {
    Host host;
    for (std::uint32_t i = 1; i <= 4; ++i) host.ask(i, 1, 64);
    host.ask(5, 0, 18, "8006000100001200");  // its answer says that the four are queued
    host.answer();
    host.read(18);
    host.server->send(1, bytes_of("11"));
    host.server->send(1, bytes_of("2222"));
    EXPECT_EQ(host.answer(), (Host::Answer{3, 1, 0, 1}));
    EXPECT_EQ(host.read(1), bytes_of("11"));
    EXPECT_EQ(host.answer(), (Host::Answer{3, 2, 0, 2}));
    EXPECT_EQ(host.read(2), bytes_of("2222"));
}

TEST(UsbServer, TellsAnUnlinkInTimeFromALateOne) {
    Host host;
    host.ask(1, 1, 64);
    host.ask(2, 1, 64);
    host.unlink(3, 2);
    EXPECT_EQ(host.answer(), (Host::Answer{4, 3, kErrno(-104), 0}));
    host.server->send(1, bytes_of("11"));
    host.answer();
    host.read(1);
    host.unlink(4, 1);
    EXPECT_EQ(host.answer(), (Host::Answer{4, 4, 0, 0})) << "it had ended";
}

// The end of a transfer and the answer to its unlink race; the end must come first, or not at all.
TEST(UsbServer, NeverEndsATransferAfterItsUnlinkWasAnswered) {
    Host host;
    constexpr std::uint32_t kRounds = 2000;
    std::jthread sender([&](const std::stop_token& stop) {
        while (!stop.stop_requested()) host.server->send(1, bytes_of("55"));
    });
    for (std::uint32_t i = 1; i <= kRounds; ++i) {
        host.ask(2 * i, 1, 64);
        host.unlink(2 * i + 1, 2 * i);
        const auto first = host.answer();
        if (first.command == 4) {
            ASSERT_EQ(first.status, kErrno(-104)) << "round " << i;
            continue;
        }
        ASSERT_EQ(first.sequence, 2 * i);
        host.read(first.length);
        ASSERT_EQ(host.answer(), (Host::Answer{4, 2 * i + 1, 0, 0})) << "round " << i;
    }
}

TEST(UsbServer, NoticesThatTheHostHasHungUp) {
    Host host;
    EXPECT_TRUE(host.server->connected());
    host.hang_up();
    while (host.server->connected()) std::this_thread::yield();
    host.server->send(1, bytes_of("11"));  // into the void
}

TEST(UsbServer, HangsUpOnWhatIsNoUsbip) {
    Host host;
    host.write({9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9});
    EXPECT_TRUE(host.read(1).empty());
    EXPECT_FALSE(host.server->connected());
}

}  // namespace
}  // namespace foverig::usb
