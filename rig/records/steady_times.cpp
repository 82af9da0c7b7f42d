#include "rig/records/steady_times.h"

#include <nlohmann/json.hpp>
#include <span>

#include "rig/stats/effective_count.h"
#include "rig/stats/warm_up.h"

namespace foverig {
namespace {

nlohmann::json percentile_json(const stats::Percentile& percentile) {
    nlohmann::json json = {{"value", nullptr},
                           {"ci95", nullptr},
                           {"effective_n", percentile.effective_n},
                           {"needed_n", percentile.needed_n}};
    if (const auto& estimate = percentile.estimate) {
        json["value"] = estimate->value;
        json["ci95"] = {estimate->ci95.low, estimate->ci95.high};
    }
    return json;
}

}  // namespace

SteadyTimes steady_times(const std::vector<double>& times_ms) {
    const std::size_t warm_up = stats::warm_up_count(times_ms);
    const auto steady = std::span(times_ms).subspan(warm_up);
    return {.warm_up_frames = warm_up,
            .n = steady.size(),
            .effective_n = stats::effective_count(steady),
            .percentiles = {stats::percentile_of(steady, 0.50), stats::percentile_of(steady, 0.90),
                            stats::percentile_of(steady, 0.99)}};
}

nlohmann::json to_json(const SteadyTimes& steady) {
    return {{"warm_up_frames", steady.warm_up_frames},
            {"n", steady.n},
            {"effective_n", steady.effective_n},
            {"p50", percentile_json(steady.percentiles[0])},
            {"p90", percentile_json(steady.percentiles[1])},
            {"p99", percentile_json(steady.percentiles[2])}};
}

}  // namespace foverig
