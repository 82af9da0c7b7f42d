#pragma once
// summary.json, schema "foverig.summary/1": add keys, never rename one.
#include <nlohmann/json_fwd.hpp>

#include "rig/identity/build_info.h"
#include "rig/identity/host_info.h"
#include "rig/records/run_record.h"

namespace foverig {

nlohmann::json summary_json(const RunRecord& run, const nlohmann::json& scenario,
                            const BuildInfo& build, const HostInfo& host,
                            std::uint64_t peak_rss_bytes);

/// [{effect, on, because, passes[], bytes, measured_ms}]
nlohmann::json plan_json(const std::vector<PlannedEffect>& plan);

}  // namespace foverig
