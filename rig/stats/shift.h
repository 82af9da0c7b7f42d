#pragma once
#include <cstddef>
#include <optional>
#include <span>

#include "rig/stats/interval.h"

namespace foverig::stats {

/// By how much the numbers of one sample are larger than those of another (Hodges and Lehmann
/// 1963).
struct Shift {
    double value = 0.0;
    std::optional<Interval> ci95;  ///< distribution-free; ties do not narrow it; absent: too few
    std::size_t n = 0;             ///< of the smaller sample
};

inline constexpr std::size_t kLeastRuns = 4;
inline constexpr std::size_t kLeastPairs = 6;

/// Median of all differences after - before; its interval is that of the rank-sum test,
/// which fewer than kLeastRuns a side have not. Both hold at least one number.
Shift shift_between(std::span<const double> before, std::span<const double> after);

/// Of pairs made one beside the other, so that a drift of both is gone: median of the means of any
/// two of the pairs' differences (Walsh averages), interval of the signed-rank test. Fewer than
/// kLeastPairs have none. Both of one length, at least one.
Shift paired_shift(std::span<const double> before, std::span<const double> after);

}  // namespace foverig::stats
