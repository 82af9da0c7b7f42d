#include "rig/stats/centre.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "rig/stats/quantile.h"

namespace foverig::stats {

double mean_of(std::span<const double> numbers) {
    return std::accumulate(numbers.begin(), numbers.end(), 0.0) /
           static_cast<double>(numbers.size());
}

double median_of(std::span<const double> numbers) {
    std::vector<double> sorted(numbers.begin(), numbers.end());
    std::sort(sorted.begin(), sorted.end());
    return quantile(sorted, 0.5);
}

}  // namespace foverig::stats
