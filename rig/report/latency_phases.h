#pragma once
#include <string>

#include "rig/report/run_data.h"

namespace foverig::report {

/// Latency, lag and error right after a movement begins and later, with what that means. Empty
/// where the summary was written before there were phases.
std::string latency_phases(const RunData& run);

}  // namespace foverig::report
