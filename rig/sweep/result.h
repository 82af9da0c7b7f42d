#pragma once
// What a sweep found: pareto.json.
#include <nlohmann/json.hpp>

#include "rig/sweep/merged.h"

namespace foverig::sweep {

/// Schema "foverig.pareto/1" (docs/sweeps.md): every point with its times, errors, rays, passes and
/// memory; the front; what one more millisecond buys along it; the cheapest settings within given
/// errors. Of a sweep without missing points. At fixed cost it depends on the definition and the
/// program alone.
nlohmann::ordered_json pareto_json(const Measured& measured);

}  // namespace foverig::sweep
