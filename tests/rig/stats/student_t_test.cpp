#include "rig/stats/student_t.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace foverig::stats {
namespace {

// Two-sided 5 % points, any table of Student's t.
TEST(StudentT, MatchesTheTable) {
    constexpr std::array<std::pair<int, double>, 10> kTable{{{1, 12.706},
                                                             {2, 4.303},
                                                             {3, 3.182},
                                                             {4, 2.776},
                                                             {5, 2.571},
                                                             {9, 2.262},
                                                             {10, 2.228},
                                                             {20, 2.086},
                                                             {30, 2.042},
                                                             {120, 1.980}}};
    for (const auto& [freedom, bound] : kTable)
        EXPECT_NEAR(student_t_bound(freedom), bound, 5e-4) << freedom;
    EXPECT_NEAR(student_t_bound(100'000), 1.95996, 1e-4);
}

// One degree is Cauchy's: P(|T| <= 1) = 1/2; two: t / sqrt(2 + t^2).
TEST(StudentT, HasItsClosedForms) {
    EXPECT_NEAR(student_t_within(1.0, 1), 0.5, 1e-15);
    EXPECT_NEAR(student_t_within(3.0, 2), 3.0 / std::sqrt(11.0), 1e-15);
    EXPECT_EQ(student_t_within(0.0, 7), 0.0);
}

// Mean 2, standard error sqrt(1 / 3), times 4.3027.
TEST(MeanInterval, IsTheTextbookOne) {
    const auto interval = mean_interval(std::vector<double>{1.0, 2.0, 3.0}).value();
    EXPECT_NEAR(interval.low, 2.0 - 4.302653 * 0.577350, 1e-5);
    EXPECT_NEAR(interval.high, 2.0 + 4.302653 * 0.577350, 1e-5);
    EXPECT_FALSE(mean_interval(std::vector<double>{1.0}).has_value());
}

}  // namespace
}  // namespace foverig::stats
