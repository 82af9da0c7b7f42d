#pragma once
#include <string>
#include <vector>

#include "rig/report/run_data.h"

namespace foverig::compare {

/// Throws UsageError, in one sentence that says what differs, unless all runs have one scenario,
/// kind of build, backend and host; keys in `allowed` (dotted, as "foveation.p_min" or "host.cpu")
/// may differ. Version, commit and compiler may, since they are what is compared.
void check_comparable(const std::vector<report::RunData>& runs,
                      const std::vector<std::string>& allowed);

}  // namespace foverig::compare
