#pragma once
#include <string>

#include "rig/report/run_data.h"

namespace foverig::report {

/// Motion and gaze to photon, taken apart: the mean of each link, which add up to the mean whole.
std::string latency_chain(const RunData& run);

}  // namespace foverig::report
