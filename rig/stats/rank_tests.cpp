#include "rig/stats/rank_tests.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace foverig::stats {
namespace {

constexpr std::size_t kExactUpTo = 100;
constexpr double kTail = (1.0 - kConfidence) / 2.0;
constexpr double kNormalQuantile = 1.959963984540054;  // at 1 - kTail

/// Chance of each U where any m of m + n ranks are as likely to be the first sample's.
/// Chances instead of counts, which outgrow whole numbers.
std::vector<double> rank_sum_chances(std::size_t m, std::size_t n) {
    // chances[i][u]: i of the ranks so far are chosen, their sum u above the least that i can have.
    std::vector<std::vector<double>> chances(m + 1, std::vector<double>(m * n + 1, 0.0));
    chances[0][0] = 1.0;
    for (std::size_t rank = 1; rank <= m + n; ++rank) {
        const auto ranks_left = static_cast<double>(m + n - rank + 1);
        for (std::size_t i = std::min(rank, m) + 1; i-- > 0;) {
            const double leave = std::max(0.0, 1.0 - static_cast<double>(m - i) / ranks_left);
            for (double& chance : chances[i]) chance *= leave;
            if (i == 0) continue;
            const double choose = static_cast<double>(m - i + 1) / ranks_left;
            for (std::size_t u = rank - i; u <= m * n; ++u)
                chances[i][u] += choose * chances[i - 1][u - (rank - i)];
        }
    }
    return chances[m];
}

/// Chance of each W: each rank is in it or not.
std::vector<double> signed_rank_chances(std::size_t n) {
    std::vector<double> chances(n * (n + 1) / 2 + 1, 0.0);
    chances[0] = 1.0;
    for (std::size_t rank = 1; rank <= n; ++rank) {
        for (std::size_t w = chances.size(); w-- > 0;)
            chances[w] = 0.5 * (chances[w] + (w >= rank ? chances[w - rank] : 0.0));
    }
    return chances;
}

std::size_t depth_of(const std::vector<double>& chances) {
    double below = 0.0;
    std::size_t depth = 0;
    while (depth < chances.size() && below + chances[depth] <= kTail) below += chances[depth++];
    return depth;
}

std::size_t normal_depth(double mean, double variance) {
    return static_cast<std::size_t>(std::max(0.0, mean - kNormalQuantile * std::sqrt(variance)));
}

}  // namespace

std::size_t rank_sum_depth(std::size_t m, std::size_t n) {
    if (m == 0 || n == 0) return 0;
    if (m + n <= kExactUpTo) return depth_of(rank_sum_chances(m, n));
    const auto pairs = static_cast<double>(m * n);
    return normal_depth(pairs / 2.0, pairs * static_cast<double>(m + n + 1) / 12.0);
}

std::size_t signed_rank_depth(std::size_t n) {
    if (n == 0) return 0;
    if (n <= kExactUpTo) return depth_of(signed_rank_chances(n));
    const auto count = static_cast<double>(n);
    return normal_depth(count * (count + 1.0) / 4.0,
                        count * (count + 1.0) * (2.0 * count + 1.0) / 24.0);
}

}  // namespace foverig::stats
