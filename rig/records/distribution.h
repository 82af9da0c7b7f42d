#pragma once
#include <array>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

namespace foverig {

/// What reports say of a set of numbers. Percentiles are linear between order statistics (as in
/// numpy and R type 7); `p50_ci95` is the narrowest symmetric pair of order statistics that covers
/// the median with at least 95 % (binomial; no value below 6 numbers, where none does).
struct Distribution {
    std::uint64_t n = 0;
    double mean = 0.0;
    double min = 0.0;
    double p50 = 0.0;
    double p90 = 0.0;
    double p99 = 0.0;
    double max = 0.0;
    std::optional<std::array<double, 2>> p50_ci95;
};

/// No value for no numbers.
std::optional<Distribution> distribution_of(std::vector<double> values);

/// The shape of DESIGN's summary; null for no value.
nlohmann::json to_json(const std::optional<Distribution>& distribution);

}  // namespace foverig
