#include "rig/stats/rank_tests.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace foverig::stats {
namespace {

/// Depth from how often each value of the statistic comes, over all equally likely outcomes.
std::size_t depth_of(const std::vector<std::uint64_t>& ways) {
    std::uint64_t all = 0;
    for (const std::uint64_t count : ways) all += count;
    std::uint64_t below = 0;
    std::size_t depth = 0;
    while (40 * (below + ways[depth]) <= all) below += ways[depth++];
    return depth;
}

/// Every choice of m out of m + n ranks, one by one.
std::size_t enumerated_rank_sum(unsigned m, unsigned n) {
    std::vector<std::uint64_t> ways(std::size_t{m} * n + 1);
    for (std::uint32_t chosen = 0; chosen < (1U << (m + n)); ++chosen) {
        if (static_cast<unsigned>(std::popcount(chosen)) != m) continue;
        std::size_t sum = 0;
        for (unsigned rank = 0; rank < m + n; ++rank)
            if ((chosen >> rank & 1U) != 0) sum += rank;
        ++ways[sum - m * (m - 1) / 2];
    }
    return depth_of(ways);
}

std::size_t enumerated_signed_rank(unsigned n) {
    std::vector<std::uint64_t> ways(std::size_t{n} * (n + 1) / 2 + 1);
    for (std::uint32_t positive = 0; positive < (1U << n); ++positive) {
        std::size_t sum = 0;
        for (unsigned rank = 0; rank < n; ++rank)
            if ((positive >> rank & 1U) != 0) sum += rank + 1;
        ++ways[sum];
    }
    return depth_of(ways);
}

TEST(RankSumDepth, AgreesWithEveryAssignment) {
    for (unsigned m = 1; m <= 8; ++m)
        for (unsigned n = 1; n <= 9; ++n)
            EXPECT_EQ(rank_sum_depth(m, n), enumerated_rank_sum(m, n)) << m << " and " << n;
}

// Critical values of U, two-sided 5 % (Siegel and Castellan 1988, table J, and others): the
// depth is one more.
TEST(RankSumDepth, MatchesThePublishedTable) {
    struct Row {
        std::size_t m, n, critical;
    };
    for (const Row& row : {Row{4, 4, 0}, Row{5, 5, 2}, Row{6, 6, 5}, Row{7, 7, 8}, Row{8, 8, 13},
                           Row{9, 9, 17}, Row{10, 10, 23}, Row{12, 12, 37}, Row{15, 15, 64},
                           Row{20, 20, 127}, Row{5, 10, 8}, Row{10, 20, 55}, Row{3, 5, 0}})
        EXPECT_EQ(rank_sum_depth(row.m, row.n), row.critical + 1) << row.m << " and " << row.n;
    EXPECT_EQ(rank_sum_depth(3, 3), 0U);
    EXPECT_EQ(rank_sum_depth(3, 4), 0U);
    EXPECT_EQ(rank_sum_depth(0, 4), 0U);
}

TEST(SignedRankDepth, AgreesWithEverySign) {
    for (unsigned n = 1; n <= 16; ++n)
        EXPECT_EQ(signed_rank_depth(n), enumerated_signed_rank(n)) << n;
}

// Critical values of W, two-sided 5 % (Wilcoxon and Wilcox 1964).
TEST(SignedRankDepth, MatchesThePublishedTable) {
    constexpr std::array<std::array<std::size_t, 2>, 11> kRows{{{6, 0},
                                                                {7, 2},
                                                                {8, 3},
                                                                {9, 5},
                                                                {10, 8},
                                                                {11, 10},
                                                                {12, 13},
                                                                {13, 17},
                                                                {15, 25},
                                                                {20, 52},
                                                                {25, 89}}};
    for (const auto& [n, critical] : kRows) EXPECT_EQ(signed_rank_depth(n), critical + 1) << n;
    EXPECT_EQ(signed_rank_depth(5), 0U);
    EXPECT_EQ(signed_rank_depth(0), 0U);
}

TEST(RankTests, AreSmoothWhereTheNormalApproximationTakesOver) {
    const auto ratio = [](std::size_t after, std::size_t before) {
        return static_cast<double>(after) / static_cast<double>(before);
    };
    EXPECT_NEAR(ratio(rank_sum_depth(51, 50), rank_sum_depth(50, 50)), 1.02, 0.01);
    EXPECT_NEAR(ratio(signed_rank_depth(101), signed_rank_depth(100)), 1.02, 0.01);
}

}  // namespace
}  // namespace foverig::stats
