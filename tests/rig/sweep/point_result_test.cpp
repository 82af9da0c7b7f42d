#include "rig/sweep/point_result.h"

#include <gtest/gtest.h>

#include "tests/rig/stats/series.h"

namespace foverig::sweep {
namespace {

Times run_of(int repetition, std::vector<double> frame_ms) {
    Times times;
    times.repetition = repetition;
    times.frame_ms = std::move(frame_ms);
    times.pass_ms = {{"trace", 1.0 + repetition}};
    return times;
}

// Medians 10, 11, 12: mean 11, Student's t of two degrees 4.3027 times sqrt(1 / 3).
TEST(PointTimes, TakeTheRunAsTheUnit) {
    const auto times = times_of(
        {run_of(0, {99, 9, 10, 11}), run_of(1, {99, 11, 11, 11}), run_of(2, {99, 13, 12, 12})}, 1,
        13.0);
    EXPECT_EQ(times.runs_ms, (std::vector<double>{10, 11, 12}));
    EXPECT_DOUBLE_EQ(times.ms.value, 11.0);
    EXPECT_NEAR(times.ms.ci95->high, 11.0 + 4.302653 * 0.577350, 1e-5);
    EXPECT_DOUBLE_EQ(times.pass_ms.at("trace"), 2.0);
    EXPECT_EQ(times.missed_ratio, 0.0);
    EXPECT_FALSE(times.percentiles[2].estimate.has_value()) << "nine frames know no p99";
}

// 10, 14 and 27 ms at 13.3 ms: shown after 1, 2 and 3 VSyncs, of which 3 repeat an older frame.
TEST(PointTimes, MissTheVsyncsThatBeginMeanwhile) {
    const auto times = times_of({run_of(0, {10, 14, 27})}, 0, 1000.0 / 75.0);
    EXPECT_DOUBLE_EQ(times.missed_ratio, 3.0 / 6.0);
    EXPECT_FALSE(times.ms.ci95.has_value()) << "one run has no interval";
    EXPECT_DOUBLE_EQ(modelled_times(20.0, 13.0).missed_ratio, 0.5);
    EXPECT_EQ(modelled_times(13.0, 13.0).missed_ratio, 0.0);
    EXPECT_EQ(modelled_times(0.0, 13.0).missed_ratio, 0.0);
}

TEST(PointErrors, AreMeansBeyondTheWarmUp) {
    Accuracy accuracy;
    accuracy.errors["flip"] = {0.9, 0.1, 0.2, 0.3};
    const auto errors = errors_of(accuracy, 1);
    EXPECT_NEAR(errors.at("flip").mean.value, 0.2, 1e-15);
    EXPECT_EQ(errors.at("flip").worst, 0.3);
    EXPECT_FALSE(errors.at("flip").percentiles[0].estimate.has_value()) << "nor have they a median";
    EXPECT_FALSE(errors.at("flip").mean.ci95.has_value()) << "three frames are too few";
    for (const double noise : stats::test::autoregressive(200, 0.3, 1))
        accuracy.errors["flip"].push_back(0.2 + 0.01 * noise);
    const auto many = errors_of(accuracy, 1).at("flip").mean;
    ASSERT_TRUE(many.ci95.has_value());
    EXPECT_LT(many.ci95->low, 0.2);
    EXPECT_GT(many.ci95->high, 0.2);
    EXPECT_LT(many.ci95->high - many.ci95->low, 0.01);
    const auto p90 = errors_of(accuracy, 1).at("flip").percentiles[1];
    ASSERT_TRUE(p90.estimate.has_value());
    EXPECT_GT(p90.estimate->value, many.value);
}

}  // namespace
}  // namespace foverig::sweep
