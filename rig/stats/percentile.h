#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "rig/stats/interval.h"

namespace foverig::stats {

struct Estimate {
    double value = 0.0;
    Interval ci95;
};

/// A percentile of a series in time, or why there is none.
struct Percentile {
    double share = 0.0;
    std::uint64_t n = 0;
    std::uint64_t effective_n = 0;     ///< as many independent numbers would know of it
    std::uint64_t needed_n = 0;        ///< that it takes
    std::optional<Estimate> estimate;  ///< absent: effective_n < needed_n, "n too small"
};

/// The interval is that of order statistics for effective_n independent numbers, which comes from
/// the autocorrelation of "below the percentile or not": it is that which makes it uncertain.
Percentile percentile_of(std::span<const double> series, double share);

}  // namespace foverig::stats
