#include "rig/stats/shift.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/rig/stats/series.h"

namespace foverig::stats {
namespace {

// Hollander and Wolfe 1999, example 4.1 (permeability of chorioamnion): -0.305 in [-0.76, 0.15].
TEST(Shift, AgreesWithTheTextbook) {
    const std::vector<double> at_term{0.80, 0.83, 1.89, 1.04, 1.45, 1.38, 1.91, 1.64, 0.73, 1.46};
    const std::vector<double> early{1.15, 0.88, 0.90, 0.74, 1.21};
    const Shift shift = shift_between(at_term, early);
    EXPECT_NEAR(shift.value, -0.305, 1e-12);
    ASSERT_TRUE(shift.ci95.has_value());
    EXPECT_NEAR(shift.ci95->low, -0.76, 1e-12);
    EXPECT_NEAR(shift.ci95->high, 0.15, 1e-12);
}

// The same, example 3.1 (depression scale): -0.46 in [-0.786, -0.010].
TEST(PairedShift, AgreesWithTheTextbook) {
    const std::vector<double> before{1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30};
    const std::vector<double> after{0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29};
    const Shift shift = paired_shift(before, after);
    EXPECT_NEAR(shift.value, -0.46, 1e-12);
    ASSERT_TRUE(shift.ci95.has_value());
    EXPECT_NEAR(shift.ci95->low, -0.786, 1e-12);
    EXPECT_NEAR(shift.ci95->high, -0.010, 1e-12);
}

// Walsh averages of ten permeability constants: 1.13 to 1.67, the 9th and the 47th (course
// notes of W. R. Stephenson, Iowa State University, Stat 403, "membrane").
TEST(PairedShift, AgreesWithACoursesWalshAverages) {
    const std::vector<double> constants{0.90, 1.13, 1.89, 1.14, 1.45, 1.38, 1.91, 1.64, 0.83, 1.46};
    const Shift shift = paired_shift(std::vector<double>(10, 0.0), constants);
    EXPECT_NEAR(shift.value, 1.385, 1e-12);
    ASSERT_TRUE(shift.ci95.has_value());
    EXPECT_NEAR(shift.ci95->low, 1.13, 0.006);
    EXPECT_NEAR(shift.ci95->high, 1.67, 0.006);
}

TEST(Shift, HasNoIntervalOfTooFew) {
    const std::vector<double> three{1.0, 2.0, 3.0};
    const std::vector<double> four{1.0, 2.0, 3.0, 4.0};
    EXPECT_FALSE(shift_between(three, three).ci95.has_value());
    EXPECT_TRUE(shift_between(four, four).ci95.has_value());
    EXPECT_FALSE(paired_shift(four, four).ci95.has_value());
    EXPECT_EQ(shift_between({{7.0}}, {{9.0}}).value, 2.0);
}

TEST(Shift, OfEqualNumbersIsNothing) {
    const std::vector<double> same(10, 5.0);
    const Shift shift = shift_between(same, same);
    EXPECT_EQ(shift.value, 0.0);
    EXPECT_EQ(shift.ci95->low, 0.0);
    EXPECT_EQ(shift.ci95->high, 0.0);
}

// 95 % of 2000 is 1900, sigma 9.7; heavy tails, five and seven numbers.
TEST(Shift, HoldsTheTruthAsOftenAsItSays) {
    int held = 0;
    int held_paired = 0;
    for (std::uint64_t trial = 0; trial < 2000; ++trial) {
        const motion::Draws draws(trial, 1);
        std::vector<double> before, after;
        for (std::uint64_t i = 0; i < 7; ++i) {
            if (i < 5) before.push_back(draws.log_normal(i, 1.0, 1.0));
            after.push_back(draws.log_normal(100 + i, 1.0, 1.0) + 3.0);
        }
        const Interval ci = shift_between(before, after).ci95.value();
        held += ci.low <= 3.0 && 3.0 <= ci.high ? 1 : 0;
        std::vector<double> first, second;
        for (std::uint64_t i = 0; i < 7; ++i) {
            const double drift = 50.0 * draws.normal(300 + i);
            first.push_back(drift + draws.normal(400 + i));
            second.push_back(drift + draws.normal(500 + i) + 3.0);
        }
        const Interval paired = paired_shift(first, second).ci95.value();
        held_paired += paired.low <= 3.0 && 3.0 <= paired.high ? 1 : 0;
    }
    EXPECT_GE(held, 1870);
    EXPECT_GE(held_paired, 1870);
}

}  // namespace
}  // namespace foverig::stats
