#pragma once
#include <nlohmann/json.hpp>
#include <vector>

#include "rig/report/run_data.h"

namespace foverig::exports {

/// Runs as Google Benchmark writes its results, each a repetition, so that its compare.py reads
/// them: medians beyond the warm-up of frame time, latencies and passes, in microseconds. What was
/// measured in wall or lockstep time stands in real_time and cpu_time both, as no CPU time is
/// measured.
nlohmann::ordered_json benchmark_json(const std::vector<report::RunData>& runs);

}  // namespace foverig::exports
