#pragma once
#include <string>

#include "rig/report/run_data.h"

namespace foverig::report {

/// Where the frame time goes: one stacked bar of means, the passes frame by frame where they were
/// recorded, and a table.
std::string pass_bars(const RunData& run);

}  // namespace foverig::report
