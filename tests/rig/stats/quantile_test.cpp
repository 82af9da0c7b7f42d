#include "rig/stats/quantile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace foverig::stats {
namespace {

/// P(low <= B < high) for B of n trials, term by term from exact ratios in long double.
long double coverage(std::uint64_t n, long double share, const Ranks& ranks) {
    long double chance = std::pow(1.0L - share, static_cast<long double>(n));
    long double sum = 0.0L;
    for (std::uint64_t k = 0; k < ranks.high; ++k) {
        if (k >= ranks.low) sum += chance;
        chance *= static_cast<long double>(n - k) / static_cast<long double>(k + 1) * share /
                  (1.0L - share);
    }
    return sum;
}

// numpy.percentile([1, 2, 4, 8, 16], [0, 50, 90, 99, 100])
TEST(Quantile, AgreesWithNumpy) {
    const std::vector<double> numbers{1.0, 2.0, 4.0, 8.0, 16.0};
    EXPECT_DOUBLE_EQ(quantile(numbers, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(quantile(numbers, 0.5), 4.0);
    EXPECT_DOUBLE_EQ(quantile(numbers, 0.9), 12.8);
    EXPECT_DOUBLE_EQ(quantile(numbers, 0.99), 15.68);
    EXPECT_DOUBLE_EQ(quantile(numbers, 1.0), 16.0);
    EXPECT_DOUBLE_EQ(quantile(std::vector<double>{3.0}, 0.99), 3.0);
}

TEST(QuantileRanks, CoverTheQuantileAndNoNarrowerOnesWould) {
    for (const std::uint64_t n : {6U, 7U, 29U, 30U, 90U, 299U, 300U, 1000U}) {
        for (const double share : {0.5, 0.9, 0.99}) {
            const auto ranks = quantile_ranks(n, share);
            if (n < least_count(share)) {
                EXPECT_FALSE(ranks.has_value()) << n << " of " << share;
                continue;
            }
            ASSERT_TRUE(ranks.has_value()) << n << " of " << share;
            EXPECT_GE(ranks->low, 1U);
            EXPECT_LE(ranks->high, n);
            EXPECT_GE(coverage(n, share, *ranks), 0.95L);
            const long double cut = coverage(n, share, {ranks->low + 1, ranks->high - 1});
            EXPECT_LT(cut, 0.95L) << n << " of " << share;
        }
    }
}

// The usual table of confidence limits for the median (95 %).
TEST(QuantileRanks, MatchTheTableForTheMedian) {
    struct Row {
        std::uint64_t n, low;
    };
    for (const Row& row : {Row{6, 1}, Row{9, 2}, Row{10, 2}, Row{20, 6}, Row{25, 8}, Row{100, 40},
                           Row{10001, 4902}}) {
        const auto ranks = quantile_ranks(row.n, 0.5);
        ASSERT_TRUE(ranks.has_value()) << row.n;
        EXPECT_EQ(ranks->low, row.low) << row.n;
        EXPECT_EQ(ranks->high, row.n + 1 - row.low) << row.n;
    }
    EXPECT_FALSE(quantile_ranks(5, 0.5).has_value());
    EXPECT_FALSE(quantile_ranks(1, 0.5).has_value());
}

// Largest of n is below p99 with 0.99^n: 0.99^299 = 0.0495, 0.99^298 = 0.0500 (just above).
TEST(LeastCount, IsWhereTheWholeSampleCovers) {
    EXPECT_EQ(least_count(0.5), 6U);
    EXPECT_EQ(least_count(0.9), 29U);
    EXPECT_EQ(least_count(0.99), 299U);
    EXPECT_EQ(least_count(0.999), 2995U);
}

}  // namespace
}  // namespace foverig::stats
