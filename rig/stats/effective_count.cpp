#include "rig/stats/effective_count.h"

#include <algorithm>
#include <vector>

#include "rig/stats/centre.h"

namespace foverig::stats {
namespace {

/// Sum of products of deviations `lag` apart.
double product_sum(const std::vector<double>& deviations, std::size_t lag) {
    double sum = 0.0;
    for (std::size_t i = lag; i < deviations.size(); ++i)
        sum += deviations[i] * deviations[i - lag];
    return sum;
}

}  // namespace

double effective_count(std::span<const double> series) {
    const auto n = static_cast<double>(series.size());
    const auto [least, most] = std::minmax_element(series.begin(), series.end());
    if (series.empty() || *least == *most) return n;
    const double mean = mean_of(series);
    std::vector<double> deviations;
    for (const double value : series) deviations.push_back(value - mean);
    const double variance = product_sum(deviations, 0);
    double time = -1.0;
    for (std::size_t lag = 0; lag + 1 < series.size(); lag += 2) {
        const double pair =
            (product_sum(deviations, lag) + product_sum(deviations, lag + 1)) / variance;
        if (pair <= 0.0) break;
        time += 2.0 * pair;
    }
    return n / std::clamp(time, 1.0, n);
}

}  // namespace foverig::stats
