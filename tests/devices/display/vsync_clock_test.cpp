#include "devices/display/vsync_clock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace foverig {
namespace {

HostTime at_ms(double ms) {
    return HostTime(from_seconds(1e-3 * ms));
}

constexpr double kPeriod_ms = 1000.0 / 59.94;

/// Delays of a driver: most swaps return soon after their vsync, some late.
double delay_ms(std::uint64_t n) {
    const auto hashed = static_cast<double>((n * 2654435761U) % 1000U) / 1000.0;
    return 0.15 - 0.25 * std::log(1.0 - 0.999 * hashed);
}

HostTime returned(std::uint64_t n, double period_ms = kPeriod_ms) {
    return at_ms(1000.0 + static_cast<double>(n) * period_ms + delay_ms(n));
}

std::vector<HostTime> trial(double period_ms, int count = 24) {
    std::vector<HostTime> returns;
    for (int i = 0; i < count; ++i)
        returns.push_back(returned(static_cast<std::uint64_t>(i), period_ms));
    return returns;
}

TEST(VsyncClock, TellsSwapsThatWaitFromSwapsThatDoNot) {
    EXPECT_TRUE(VsyncClock(60.0, {}).judge(trial(kPeriod_ms)));
    EXPECT_FALSE(VsyncClock(60.0, {}).judge(trial(1.2))) << "Xvfb";
    EXPECT_FALSE(VsyncClock(75.0, {}).judge(trial(kPeriod_ms))) << "another monitor's rate";
    EXPECT_FALSE(VsyncClock(60.0, {}).judge(trial(kPeriod_ms, 12))) << "too few to tell";
    std::vector<HostTime> uneven = trial(kPeriod_ms);
    for (std::size_t i = 0; i < uneven.size(); i += 2) uneven[i] += Nanoseconds(6'000'000);
    EXPECT_FALSE(VsyncClock(60.0, {}).judge(uneven));
}

TEST(VsyncClock, FirstSwapsMayFillAQueue) {
    std::vector<HostTime> returns;
    for (int i = 0; i < 3; ++i) returns.push_back(at_ms(0.3 * i));
    for (int i = 3; i < 24; ++i) returns.push_back(returned(static_cast<std::uint64_t>(i)));
    EXPECT_TRUE(VsyncClock(60.0, {}).judge(returns));
}

TEST(VsyncClock, FindsPeriodAndPhaseOfTheDisplay) {
    VsyncClock clock(60.0, {});
    ASSERT_TRUE(clock.judge(trial(kPeriod_ms)));
    const std::uint64_t first = clock.swapped(returned(24));
    std::uint64_t last = first;
    for (std::uint64_t n = 25; n < 1024; ++n) last = clock.swapped(returned(n));
    EXPECT_EQ(last - first, 999U);
    EXPECT_NEAR(clock.rate_hz(), 59.94, 0.003);
    // The true vsync 1100 and the least delay of 0.15 ms, which nothing shows.
    const std::uint64_t next = clock.number_from(at_ms(1000.0 + 1099.5 * kPeriod_ms));
    EXPECT_NEAR(to_ms(clock.vsync(next) - at_ms(1000.0 + 1100.0 * kPeriod_ms)), 0.15, 0.1);
    // Nine of ten delays lie within 0.25 ln 10 = 0.58 ms of the least.
    EXPECT_NEAR(to_ms(clock.error()), 0.58, 0.15);
}

TEST(VsyncClock, CountsVsyncsThatNoFrameMade) {
    VsyncClock clock(60.0, {});
    ASSERT_TRUE(clock.judge(trial(kPeriod_ms)));
    const std::uint64_t before = clock.swapped(returned(24));
    EXPECT_EQ(clock.swapped(returned(25)), before + 1);
    EXPECT_EQ(clock.swapped(returned(29)), before + 5);
    EXPECT_EQ(clock.swapped(returned(29) + Nanoseconds(100'000)), before + 6) << "never one twice";
}

TEST(VsyncClock, KeepsToWhatItToldOfTheNextVsyncs) {
    VsyncClock clock(60.0, {});
    ASSERT_TRUE(clock.judge(trial(kPeriod_ms)));
    for (std::uint64_t n = 24; n < 400; ++n) {
        const std::uint64_t next = clock.number_from(returned(n) + Nanoseconds(1));
        const HostTime told = clock.vsync(next + 1);
        clock.swapped(returned(n + 1));
        EXPECT_EQ(clock.vsync(next + 1), told) << n;
    }
}

TEST(VsyncClock, VsyncsFollowEachOtherAcrossFits) {
    VsyncClock clock(60.0, {});
    ASSERT_TRUE(clock.judge(trial(kPeriod_ms)));
    for (std::uint64_t n = 24; n < 300; ++n) {
        const std::uint64_t number = clock.swapped(returned(n));
        for (std::uint64_t ahead = 0; ahead < 40; ++ahead)
            EXPECT_NEAR(to_ms(clock.vsync(number + ahead + 1) - clock.vsync(number + ahead)),
                        kPeriod_ms, 1.0);
        EXPECT_EQ(clock.number_from(clock.vsync(number)), number);
    }
}

TEST(VsyncClock, KeepsAGridOfItsOwnWhereSwapsTellNothing) {
    VsyncClock clock(75.0, at_ms(10.0));
    EXPECT_FALSE(clock.measured());
    EXPECT_EQ(clock.vsync(0), at_ms(10.0));
    EXPECT_EQ(clock.vsync(75'000), at_ms(10.0 + 1e6));
    EXPECT_EQ(clock.number_from(at_ms(0.0)), 0U);
    EXPECT_EQ(clock.swapped(at_ms(10.0 + 14.0)), 2U);
    EXPECT_EQ(clock.swapped(at_ms(10.0 + 15.0)), 2U) << "the vsync of the frame before";
    EXPECT_NEAR(to_ms(clock.error()), 500.0 / 75.0, 1e-6) << "it may lie anywhere";
}

}  // namespace
}  // namespace foverig
