#pragma once
#include <string>

#include "rig/report/run_data.h"

namespace foverig::report {

/// The frames that took longest beyond the warm-up, link by link from the sensor's sample to the
/// photon, each with the pass that lies furthest above its median over the run: what to look at.
std::string worst_frames(const RunData& run);

}  // namespace foverig::report
