#include "rig/records/distribution.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace foverig {
namespace {

double percentile(const std::vector<double>& sorted, double share) {
    const double at = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const auto above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], at - static_cast<double>(below));
}

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

/// P(B = k) for B of n fair coins; by logarithms, so that it does not underflow for large n.
double fair_binomial(std::uint64_t n, std::uint64_t k) {
    const auto of = [](std::uint64_t m) { return std::lgamma(static_cast<double>(m) + 1.0); };
    return std::exp(of(n) - of(k) - of(n - k) - static_cast<double>(n) * std::log(2.0));
}

}  // namespace

std::uint64_t median_interval_rank(std::uint64_t n) {
    if (n < 2) return 0;
    // Grow from the middle: P(l <= B <= n - l) is the chance that the interval holds the median.
    std::uint64_t rank = n / 2;
    double covered = fair_binomial(n, rank);
    if (rank != n - rank) covered *= 2.0;
    while (covered < 0.95) {
        if (rank <= 1) return 0;
        --rank;
        covered += 2.0 * fair_binomial(n, rank);
    }
    return rank;
}

std::optional<Distribution> distribution_of(std::vector<double> values) {
    if (values.empty()) return std::nullopt;
    std::sort(values.begin(), values.end());
    Distribution d{.n = values.size(),
                   .mean = compensated_sum(values) / static_cast<double>(values.size()),
                   .min = values.front(),
                   .p50 = percentile(values, 0.50),
                   .p90 = percentile(values, 0.90),
                   .p99 = percentile(values, 0.99),
                   .max = values.back(),
                   .p50_ci95 = std::nullopt};
    if (const auto rank = median_interval_rank(d.n); rank > 0) {
        d.p50_ci95 = {values[rank - 1], values[values.size() - rank]};
    }
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
