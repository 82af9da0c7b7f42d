#include "simulators/gaze/least_squares.h"

#include <gtest/gtest.h>

#include "simulators/motion/random.h"

namespace foverig {
namespace {

TEST(LeastSquares, FitsTheLineOfATextbook) {
    // Through (0, 0), (1, 1), (2, 1): slope 1/2, intercept 1/6.
    const auto line = solve_least_squares({{{1, 0}, {0, 0}}, {{1, 1}, {1, -1}}, {{1, 2}, {1, -1}}});
    ASSERT_TRUE(line);
    EXPECT_NEAR((*line)[0].x, 1.0 / 6.0, 1e-15);
    EXPECT_NEAR((*line)[1].x, 0.5, 1e-15);
    EXPECT_NEAR((*line)[0].y, -1.0 / 6.0, 1e-15);
    EXPECT_NEAR((*line)[1].y, -0.5, 1e-15);
}

/// At the least sum of squares what is left is at right angles to every column.
TEST(LeastSquares, LeavesNothingAlongAnyTerm) {
    const motion::Draws draws(1, 2);
    std::vector<LinearRow> rows;
    for (std::uint64_t i = 0; i < 13; ++i) {
        std::vector<double> terms;
        for (std::uint64_t j = 0; j < 10; ++j) terms.push_back(draws.normal(20 * i + j));
        rows.push_back({terms, {draws.normal(20 * i + 11), draws.normal(20 * i + 12)}});
    }
    const auto c = solve_least_squares(rows);
    ASSERT_TRUE(c);
    for (std::size_t j = 0; j < 10; ++j) {
        dvec2 along(0.0);
        for (const LinearRow& row : rows) {
            dvec2 left = row.wanted;
            for (std::size_t k = 0; k < 10; ++k) left -= row.terms[k] * (*c)[k];
            along += row.terms[j] * left;
        }
        EXPECT_LT(glm::length(along), 1e-12) << j;
    }
}

TEST(LeastSquares, RefusesWhatIsNotDetermined) {
    EXPECT_FALSE(solve_least_squares({}));
    EXPECT_FALSE(solve_least_squares({{{1, 2}, {0, 0}}})) << "one row for two terms";
    EXPECT_FALSE(solve_least_squares({{{1, 2}, {0, 0}}, {{2, 4}, {1, 0}}, {{3, 6}, {1, 1}}}))
        << "one column is twice the other";
    EXPECT_FALSE(solve_least_squares({{{0, 0}, {0, 0}}, {{0, 0}, {1, 0}}}));
}

}  // namespace
}  // namespace foverig
