#include "rig/stats/warm_up.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "rig/stats/centre.h"

namespace foverig::stats {
namespace {

/// Median absolute deviation, scaled to the standard deviation of normal numbers.
double scaled_mad(std::span<const double> numbers, double median) {
    std::vector<double> deviations;
    for (const double number : numbers) deviations.push_back(std::abs(number - median));
    return 1.4826 * median_of(deviations);
}

}  // namespace

std::size_t warm_up_count(std::span<const double> times) {
    const std::size_t n = times.size();
    if (n < 4 * kSteadyStretch) return 0;
    const auto later = times.subspan(n / 2);
    const double level = median_of(later);
    const double bound = level + std::max(3.0 * scaled_mad(later, level), 0.01 * level);
    for (std::size_t first = 0; first <= n / 4; ++first) {
        if (times[first] <= bound && median_of(times.subspan(first, kSteadyStretch)) <= bound)
            return first;
    }
    return 0;
}

}  // namespace foverig::stats
