#include "rig/stats/verdict.h"

#include <gtest/gtest.h>

namespace foverig::stats {
namespace {

Judgement of(double value, double low, double high) {
    return judge({value, Interval{low, high}, 10}, 0.03, 4);
}

TEST(Verdict, GoesByTheWholeInterval) {
    EXPECT_EQ(of(0.05, 0.031, 0.07).verdict, Verdict::worse);
    EXPECT_EQ(of(-0.05, -0.07, -0.031).verdict, Verdict::better);
    EXPECT_EQ(of(0.01, -0.01, 0.029).verdict, Verdict::same);
    EXPECT_EQ(of(0.05, 0.029, 0.07).verdict, Verdict::cannot_tell);
    EXPECT_EQ(of(-0.02, -0.04, 0.0).verdict, Verdict::cannot_tell);
    EXPECT_EQ(of(0.03, 0.03, 0.03).verdict, Verdict::cannot_tell) << "on the threshold";
    EXPECT_STREQ(name_of(Verdict::cannot_tell), "cannot tell");
}

// Reach 0.04, room 0.02: twice as narrow takes four times the runs.
TEST(Verdict, SaysHowManyRunsWouldTell) {
    EXPECT_EQ(of(0.05, 0.01, 0.09).runs_needed, 40U);
    EXPECT_EQ(of(0.01, -0.03, 0.05).runs_needed, 40U);
    EXPECT_EQ(of(0.05, 0.0299, 0.0699).runs_needed, 11U) << "at least one more";
    EXPECT_FALSE(of(0.0301, 0.01, 0.05).runs_needed.has_value());
    EXPECT_FALSE(of(0.03, 0.01, 0.05).runs_needed.has_value());
    EXPECT_FALSE(of(0.05, 0.04, 0.06).runs_needed.has_value()) << "the verdict stands";
    EXPECT_EQ(judge({0.5, std::nullopt, 1}, 0.03, 4).runs_needed, 4U);
}

}  // namespace
}  // namespace foverig::stats
