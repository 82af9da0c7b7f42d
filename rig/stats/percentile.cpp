#include "rig/stats/percentile.h"

#include <algorithm>
#include <vector>

#include "rig/stats/effective_count.h"
#include "rig/stats/quantile.h"

namespace foverig::stats {

Percentile percentile_of(std::span<const double> series, double share) {
    Percentile percentile{.share = share,
                          .n = series.size(),
                          .effective_n = 0,
                          .needed_n = least_count(share),
                          .estimate = std::nullopt};
    if (series.empty()) return percentile;
    std::vector<double> sorted(series.begin(), series.end());
    std::sort(sorted.begin(), sorted.end());
    const double value = quantile(sorted, share);
    std::vector<double> below;
    for (const double number : series) below.push_back(number <= value ? 1.0 : 0.0);
    percentile.effective_n = static_cast<std::uint64_t>(effective_count(below));
    const auto ranks = quantile_ranks(percentile.effective_n, share);
    if (!ranks) return percentile;
    // Rank r of the effective numbers is at the share r / (effective_n + 1) of all, rounded
    // outward.
    const std::uint64_t n = percentile.n;
    const std::uint64_t of = percentile.effective_n + 1;
    const std::uint64_t low = std::max<std::uint64_t>(1, ranks->low * (n + 1) / of);
    const std::uint64_t high = std::min(n, (ranks->high * (n + 1) + of - 1) / of);
    percentile.estimate = Estimate{value, {sorted[low - 1], sorted[high - 1]}};
    return percentile;
}

}  // namespace foverig::stats
