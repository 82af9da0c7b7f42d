#include "rig/stats/warm_up.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/rig/stats/series.h"

namespace foverig::stats {
namespace {

/// 10 ms with 2 % of dependent noise.
std::vector<double> steady(int n, std::uint64_t seed = 1) {
    std::vector<double> times;
    for (const double noise : test::autoregressive(n, 0.5, seed))
        times.push_back(10.0 + 0.2 * noise);
    return times;
}

TEST(WarmUp, IsNoneOfASteadySeries) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) EXPECT_LE(warm_up_count(steady(90, seed)), 1U);
    EXPECT_EQ(warm_up_count(std::vector<double>(90, 10.0)), 0U);
}

TEST(WarmUp, IsOneColdFrame) {
    auto times = steady(90);
    times[0] *= 3.0;
    EXPECT_EQ(warm_up_count(times), 1U);
}

// 10 (1 + exp(-i / 5)) ms comes within 3 sigma (6 %) after 5 ln(1 / 0.06) = 14 frames.
TEST(WarmUp, IsTheDecayTowardsTheLevel) {
    auto times = steady(120);
    for (std::size_t i = 0; i < times.size(); ++i)
        times[i] += 10.0 * std::exp(-static_cast<double>(i) / 5.0);
    EXPECT_NEAR(static_cast<double>(warm_up_count(times)), 14.0, 3.0);
}

TEST(WarmUp, IsNotALateFrameSomewhereElse) {
    auto times = steady(90);
    for (const std::size_t late : {8U, 20U, 41U, 77U}) times[late] *= 4.0;
    EXPECT_LE(warm_up_count(times), 1U);
}

TEST(WarmUp, IsNotASceneThatIsCheaperAtFirst) {
    auto times = steady(90);
    for (std::size_t i = 0; i < 15; ++i) times[i] *= 0.5;
    EXPECT_EQ(warm_up_count(times), 0U);
}

TEST(WarmUp, IsNoneWhereItWouldBeMoreThanAQuarter) {
    auto times = steady(90);
    for (std::size_t i = 0; i < 40; ++i) times[i] *= 2.0;
    EXPECT_EQ(warm_up_count(times), 0U);
    EXPECT_EQ(warm_up_count(std::vector<double>{9, 1, 1, 1}), 0U);
}

}  // namespace
}  // namespace foverig::stats
