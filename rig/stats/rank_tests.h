#pragma once
// How far into a sorted list of differences a distribution-free interval begins: exact null
// distributions of Wilcoxon's two statistics, counted, and their normal approximations for large n.
#include <cstddef>

#include "rig/stats/interval.h"

namespace foverig::stats {

/// Two samples of m and n: the largest d with P(U < d) <= (1 - kConfidence) / 2 for the rank sum's
/// U, so that the d-th smallest and d-th largest of the m n differences bound the shift (Hollander
/// and Wolfe 1999, 4.3). 0: the samples are too small for any. Exact while m + n <= 100.
std::size_t rank_sum_depth(std::size_t m, std::size_t n);

/// The same of n pairs for the signed rank's W and the n (n + 1) / 2 Walsh averages (3.3). Exact
/// while n <= 100.
std::size_t signed_rank_depth(std::size_t n);

}  // namespace foverig::stats
