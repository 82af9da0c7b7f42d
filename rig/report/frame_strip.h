#pragma once
#include <string>

#include "rig/report/run_data.h"

namespace foverig::report {

/// Time of every frame beside the VSync budget; late and dropped frames marked.
std::string frame_strip(const RunData& run);

}  // namespace foverig::report
