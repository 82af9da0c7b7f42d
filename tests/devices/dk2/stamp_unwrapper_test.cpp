#include "devices/dk2/stamp_unwrapper.h"

#include <gtest/gtest.h>

namespace foverig::dk2 {
namespace {

using Verdict = StampUnwrapper::Verdict;

constexpr std::int64_t kWrap_us = std::int64_t{1} << 32;

std::int64_t us(Dk2Time t) {
    return t.time_since_epoch().count() / 1000;
}

TEST(StampUnwrapper, GoesOnAcrossTheWrap) {
    StampUnwrapper stamps;
    EXPECT_EQ(stamps.advance(0xFFFFFFF0u), Verdict::accepted);
    EXPECT_EQ(stamps.advance(0x00000010u), Verdict::accepted);
    EXPECT_EQ(us(stamps.now()), kWrap_us + 16);
}

TEST(StampUnwrapper, TwoHoursHoldTwoWraps) {
    StampUnwrapper stamps;
    const std::int64_t two_hours_us = 7'200'000'000;
    for (std::int64_t t = 0; t <= two_hours_us; t += 500'000'000)
        stamps.advance(static_cast<std::uint32_t>(t));
    stamps.advance(static_cast<std::uint32_t>(two_hours_us));
    EXPECT_EQ(us(stamps.now()), two_hours_us);
}

TEST(StampUnwrapper, BackwardsAndEqualStampsLeaveTheTime) {
    StampUnwrapper stamps;
    stamps.advance(1'000'000);
    EXPECT_EQ(stamps.advance(999'000), Verdict::backwards);
    EXPECT_EQ(stamps.advance(1'000'000), Verdict::duplicate);
    EXPECT_EQ(us(stamps.now()), 1'000'000);
    EXPECT_EQ(stamps.advance(1'001'000), Verdict::accepted);
}

TEST(StampUnwrapper, ARestartedDeviceIsBelievedAfterAWhile) {
    StampUnwrapper stamps;
    stamps.advance(3'000'000'000u);
    Verdict verdict = Verdict::accepted;
    std::uint32_t stamp = 3'000'000'000u - (1u << 30);
    int refused = 0;
    while ((verdict = stamps.advance(stamp)) == Verdict::backwards && refused < 100) {
        ++refused;
        stamp += 1000;
    }
    EXPECT_EQ(verdict, Verdict::restarted);
    EXPECT_EQ(refused, 15);
    EXPECT_EQ(static_cast<std::uint32_t>(us(stamps.now())), stamp);
    EXPECT_GT(us(stamps.now()), 3'000'000'000);
    EXPECT_EQ(stamps.advance(stamp + 1000), Verdict::accepted);
}

TEST(StampUnwrapper, FrameStampsLieOnTheirSideOfTheWrap) {
    StampUnwrapper stamps;
    stamps.advance(0xFFFFFF00u);
    stamps.advance(0x00000100u);
    EXPECT_EQ(us(stamps.near(0xFFFFFFF0u)), kWrap_us - 16);     // before the wrap
    EXPECT_EQ(us(stamps.near(0x00000200u)), kWrap_us + 0x200);  // a little ahead
    EXPECT_EQ(us(stamps.near(0x00000100u)), kWrap_us + 0x100);
    EXPECT_EQ(us(stamps.near(0x40000000u)), 0x40000000);  // far "ahead" is an old one
}

}  // namespace
}  // namespace foverig::dk2
