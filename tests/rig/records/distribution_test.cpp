#include "rig/records/distribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace foverig {
namespace {

/// 1..n in an order that is not sorted.
std::vector<double> shuffled(int n) {
    std::vector<double> values;
    for (int i = 0; i < n; ++i) values.push_back(i * 7919 % n + 1);  // 7919 is prime
    return values;
}

TEST(Distribution, OfNothingIsAbsent) {
    EXPECT_FALSE(distribution_of({}).has_value());
    EXPECT_TRUE(to_json(std::nullopt).is_null());
}

TEST(Distribution, OfOneNumberIsThatNumber) {
    const auto d = distribution_of({4.5}).value();
    EXPECT_EQ(d.n, 1U);
    for (const double value : {d.mean, d.min, d.p50, d.p90, d.p99, d.max}) EXPECT_EQ(value, 4.5);
    EXPECT_FALSE(d.p50_ci95.has_value());
    EXPECT_TRUE(to_json(d)["p50_ci95"].is_null());
}

TEST(Distribution, OfTwoNumbersInterpolates) {
    const auto d = distribution_of({20.0, 10.0}).value();
    EXPECT_DOUBLE_EQ(d.p50, 15.0);
    EXPECT_DOUBLE_EQ(d.p90, 19.0);
    EXPECT_DOUBLE_EQ(d.p99, 19.9);
    EXPECT_FALSE(d.p50_ci95.has_value());
}

// numpy.percentile([1, 2, 4, 8, 16], [50, 90, 99]) = [4, 12.8, 15.68]
TEST(Distribution, AgreesWithNumpy) {
    const auto d = distribution_of({16.0, 1.0, 8.0, 2.0, 4.0}).value();
    EXPECT_DOUBLE_EQ(d.p50, 4.0);
    EXPECT_DOUBLE_EQ(d.p90, 12.8);
    EXPECT_DOUBLE_EQ(d.p99, 15.68);
    EXPECT_DOUBLE_EQ(d.mean, 6.2);
}

// Ranks 469 and n + 1 - 469, from exact rational arithmetic; R's qbinom(0.025, 1000, 0.5) is 469.
TEST(Distribution, OfThousandNumbersHasTheBinomialInterval) {
    const auto d = distribution_of(shuffled(1000)).value();
    EXPECT_DOUBLE_EQ(d.p50, 500.5);
    EXPECT_DOUBLE_EQ(d.p90, 900.1);
    EXPECT_DOUBLE_EQ(d.p99, 990.01);
    ASSERT_TRUE(d.p50_ci95.has_value());
    EXPECT_EQ((*d.p50_ci95)[0], 469.0);
    EXPECT_EQ((*d.p50_ci95)[1], 532.0);
}

TEST(Distribution, OfNineHundredNinetyNineNumbersHasItsMiddle) {
    const auto d = distribution_of(shuffled(999)).value();
    EXPECT_DOUBLE_EQ(d.p50, 500.0);
    EXPECT_EQ((*d.p50_ci95)[0], 469.0);
    EXPECT_EQ((*d.p50_ci95)[1], 531.0);
    EXPECT_EQ(d.min, 1.0);
    EXPECT_EQ(d.max, 999.0);
}

TEST(Distribution, KeepsSmallNumbersBesideLargeOnes) {
    EXPECT_DOUBLE_EQ(distribution_of({1e16, 1.0, -1e16})->mean, 1.0 / 3.0);
}

}  // namespace
}  // namespace foverig
