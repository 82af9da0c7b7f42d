#include "rig/records/distribution.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "rig/stats/quantile.h"

namespace foverig {
namespace {

/// Neumaier's sum: frame times of long runs differ by orders of magnitude.
double compensated_sum(const std::vector<double>& values) {
    double sum = 0.0;
    double lost = 0.0;
    for (const double value : values) {
        const double next = sum + value;
        lost += std::abs(sum) >= std::abs(value) ? (sum - next) + value : (value - next) + sum;
        sum = next;
    }
    return sum + lost;
}

}  // namespace

std::optional<Distribution> distribution_of(std::vector<double> values) {
    if (values.empty()) return std::nullopt;
    std::sort(values.begin(), values.end());
    Distribution d{.n = values.size(),
                   .mean = compensated_sum(values) / static_cast<double>(values.size()),
                   .min = values.front(),
                   .p50 = stats::quantile(values, 0.50),
                   .p90 = stats::quantile(values, 0.90),
                   .p99 = stats::quantile(values, 0.99),
                   .max = values.back(),
                   .p50_ci95 = std::nullopt};
    if (const auto ranks = stats::quantile_ranks(d.n, 0.5))
        d.p50_ci95 = {values[ranks->low - 1], values[ranks->high - 1]};
    return d;
}

nlohmann::json to_json(const std::optional<Distribution>& distribution) {
    if (!distribution) return nullptr;
    const Distribution& d = *distribution;
    nlohmann::json json = {{"n", d.n},     {"mean", d.mean}, {"min", d.min}, {"p50", d.p50},
                           {"p90", d.p90}, {"p99", d.p99},   {"max", d.max}, {"p50_ci95", nullptr}};
    if (d.p50_ci95) json["p50_ci95"] = *d.p50_ci95;
    return json;
}

}  // namespace foverig
