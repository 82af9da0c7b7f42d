#include "simulators/usb/in_queue.h"

#include <gtest/gtest.h>

namespace foverig::usb {
namespace {

HostTime at_ms(int ms) {
    return HostTime(std::chrono::milliseconds(ms));
}
std::vector<std::byte> packet(int value, std::size_t size = 4) {
    return std::vector<std::byte>(size, static_cast<std::byte>(value));
}
Submit asks(std::uint32_t sequence, std::uint32_t length = 64) {
    return {.sequence = sequence, .endpoint = 1, .to_host = true, .length = length};
}

TEST(InQueue, KeepsPacketsInOrderWhileNoTransferIsThere) {
    InQueue queue;
    EXPECT_FALSE(queue.submit(asks(1), at_ms(0)));
    EXPECT_EQ(queue.push(packet(1), at_ms(1))->submit.sequence, 1u);
    for (int i = 2; i <= 9; ++i) EXPECT_FALSE(queue.push(packet(i), at_ms(i)));
    for (int i = 2; i <= 9; ++i) {
        const auto ended = queue.submit(asks(static_cast<std::uint32_t>(i)), at_ms(20 + i));
        ASSERT_TRUE(ended);
        EXPECT_EQ(ended->data, packet(i));
    }
    EXPECT_EQ(queue.unheard(), 0u);
}

TEST(InQueue, EndsTransfersInTheOrderInWhichTheyCame) {
    InQueue queue;
    for (std::uint32_t i = 1; i <= 8; ++i) EXPECT_FALSE(queue.submit(asks(i), at_ms(0)));
    EXPECT_EQ(queue.push(packet(0), at_ms(1))->submit.sequence, 1u);
    EXPECT_TRUE(queue.unlink(2));
    EXPECT_FALSE(queue.unlink(2));
    EXPECT_FALSE(queue.unlink(1)) << "it has ended";
    EXPECT_EQ(queue.push(packet(0), at_ms(2))->submit.sequence, 3u);
}

TEST(InQueue, ThrowsAwayWhatNobodyListensTo) {
    InQueue queue;
    for (int i = 0; i < 1000; ++i) queue.push(packet(i), at_ms(i));
    EXPECT_EQ(queue.unheard(), 1000u);
    EXPECT_FALSE(queue.submit(asks(1), at_ms(1000))) << "nothing old is kept";
    ASSERT_TRUE(queue.push(packet(7), at_ms(1001)));
    // A host that has just asked will ask again.
    EXPECT_FALSE(queue.push(packet(8), at_ms(1400)));
    EXPECT_EQ(queue.submit(asks(2), at_ms(1450))->data, packet(8));
}

/// A host that takes every second report of a device never has one that is more than a second old.
TEST(InQueue, KeepsUpWithAHostThatIsSlowerThanTheDevice) {
    InQueue queue;
    std::uint32_t taken = 0;
    for (int ms = 0; ms < 20000; ++ms) {
        std::vector<std::byte> stamp(4);
        write_u32(stamp, 0, static_cast<std::uint32_t>(ms));
        auto ended = queue.push(std::move(stamp), at_ms(ms));
        if (!ended && ms % 2 == 0) ended = queue.submit(asks(++taken), at_ms(ms));
        if (!ended) continue;
        ASSERT_LE(ms - static_cast<int>(read_u32(ended->data, 0)), 1000);
    }
    EXPECT_NEAR(static_cast<double>(queue.unheard()), 20000 - 10000 - 1000, 5);
}

TEST(InQueue, SaysWhenAPacketIsTooLongForItsTransfer) {
    InQueue queue;
    queue.submit(asks(1, 8), at_ms(0));
    const auto ended = queue.push(packet(1, 9), at_ms(1));
    ASSERT_TRUE(ended);
    EXPECT_EQ(ended->status, kTooLong);
    EXPECT_EQ(ended->data.size(), 8u);
}

}  // namespace
}  // namespace foverig::usb
