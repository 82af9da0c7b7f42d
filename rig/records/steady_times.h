#pragma once
// Frame times once the run is warm, as far as their number allows to say.
#include <array>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "rig/stats/percentile.h"

namespace foverig {

struct SteadyTimes {
    std::size_t warm_up_frames = 0;  ///< the first so many are left out; they stay in frames.csv
    std::size_t n = 0;
    double effective_n = 0.0;                      ///< of the mean
    std::array<stats::Percentile, 3> percentiles;  ///< p50, p90, p99
};

/// `times_ms` of all frames in their order.
SteadyTimes steady_times(const std::vector<double>& times_ms);

/// {warm_up_frames, n, effective_n, p50, p90, p99}, of each percentile {value, ci95[2],
/// effective_n, needed_n}; value and interval are null where effective_n is too small.
nlohmann::json to_json(const SteadyTimes& steady);

}  // namespace foverig
