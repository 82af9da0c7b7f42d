#include "rig/stats/percentile.h"

#include <gtest/gtest.h>

#include "tests/rig/stats/series.h"

namespace foverig::stats {
namespace {

using test::autoregressive;

TEST(Percentile, IsNoNumberWhereThereAreTooFew) {
    const auto p99 = percentile_of(autoregressive(90, 0.0, 1), 0.99);
    EXPECT_FALSE(p99.estimate.has_value());
    EXPECT_EQ(p99.needed_n, 299U);
    EXPECT_EQ(p99.n, 90U);
    EXPECT_FALSE(percentile_of({}, 0.5).estimate.has_value());
    EXPECT_FALSE(percentile_of(autoregressive(5, 0.0, 1), 0.5).estimate.has_value());
    EXPECT_TRUE(percentile_of(autoregressive(400, 0.0, 1), 0.99).estimate.has_value());
}

TEST(Percentile, OfEqualNumbersIsThatNumber) {
    const auto p50 = percentile_of(std::vector<double>(20, 3.5), 0.5);
    ASSERT_TRUE(p50.estimate.has_value());
    EXPECT_EQ(p50.estimate->value, 3.5);
    EXPECT_EQ(p50.estimate->ci95.low, 3.5);
    EXPECT_EQ(p50.estimate->ci95.high, 3.5);
    EXPECT_EQ(p50.effective_n, 20U);
}

// 1..1000 in an order without memory: ranks 469 and 532 (R: qbinom(0.025, 1000, 0.5) is 469).
TEST(Percentile, OfIndependentNumbersHasTheBinomialInterval) {
    std::vector<double> numbers;
    for (int i = 1; i <= 1000; ++i) numbers.push_back(i);
    const motion::Draws draws(1, 1);
    for (std::size_t i = numbers.size(); i-- > 1;)
        std::swap(numbers[i], numbers[draws.bits(i) % (i + 1)]);
    const auto p50 = percentile_of(numbers, 0.5);
    ASSERT_TRUE(p50.estimate.has_value());
    EXPECT_DOUBLE_EQ(p50.estimate->value, 500.5);
    EXPECT_NEAR(p50.estimate->ci95.low, 469.0, 4.0);
    EXPECT_NEAR(p50.estimate->ci95.high, 532.0, 4.0);
}

/// Of 400 series, how many intervals hold the median, which is 0.
int held(double phi) {
    int count = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const auto p50 = percentile_of(autoregressive(400, phi, seed), 0.5);
        const Interval ci = p50.estimate.value().ci95;
        count += ci.low <= 0.0 && 0.0 <= ci.high ? 1 : 0;
    }
    return count;
}

// 95 % of 400 is 380, sigma 4.4; what takes frames for independent would hold 50 % at phi 0.9.
TEST(Percentile, KeepsItsPromiseForDependentNumbers) {
    EXPECT_GE(held(0.0), 367);
    EXPECT_GE(held(0.6), 360);
    EXPECT_GE(held(0.9), 345);
}

}  // namespace
}  // namespace foverig::stats
