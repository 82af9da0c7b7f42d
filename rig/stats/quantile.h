#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "rig/stats/interval.h"

namespace foverig::stats {

/// Linear between order statistics (Hyndman and Fan 1996, type 7: numpy's and R's default).
/// `sorted` holds at least one number; `share` is 0..1.
double quantile(std::span<const double> sorted, double share);

/// Order statistics, counted from 1.
struct Ranks {
    std::uint64_t low = 0;
    std::uint64_t high = 0;
};

/// Ranks of the order statistics of `n` independent numbers that hold their distribution's quantile
/// with at least `confidence`, whatever the distribution (binomial); grown from the likeliest rank,
/// symmetric for the median.
/// No value where n is too small for any.
std::optional<Ranks> quantile_ranks(std::uint64_t n, double share, double confidence = kConfidence);

/// The smallest n that has such ranks: 6 for the median, 29 for p90, 299 for p99.
std::uint64_t least_count(double share, double confidence = kConfidence);

}  // namespace foverig::stats
