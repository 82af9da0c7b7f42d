#pragma once
#include <vector>

#include "rig/records/fail_if.h"
#include "rig/scenario/scenario.h"

namespace foverig {

/// Throws UsageError for a check whose key the summary of such a run cannot have, naming the
/// nearest one, so that a mistyped key costs no run. Which passes run is known afterwards alone: of
/// pass_time_ms.NAME.NUMBER any name is taken here, and refused where the run had no such pass.
void refuse_unknown_keys(const std::vector<FailIf>& checks, const Scenario& scenario);

}  // namespace foverig
