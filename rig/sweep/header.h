#pragma once
// The first line of a shard's file: all that the others mean and depend on.
#include <nlohmann/json.hpp>

#include "rig/identity/build_info.h"
#include "rig/identity/host_info.h"
#include "rig/sweep/definition.h"

namespace foverig::sweep {

/// {name, scenario, devices, knobs, points[], default_point, reference, repetitions, ...}: the
/// sweep, resolved. What a sweep does not use (prices, cases, paper, stretches) is not in it.
nlohmann::json definition_json(const Sweep& sweep);

/// {schema "foverig.sweep/1", sweep, build, host}. `program` tells builds of one commit apart.
nlohmann::json header_json(const Sweep& sweep, const BuildInfo& build, const HostInfo& host,
                           const std::string& program);

/// A KeyValue as JSON.
nlohmann::json value_json(const KeyValue& value);

}  // namespace foverig::sweep
