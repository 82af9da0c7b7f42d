#pragma once
#include <string>

#include "rig/report/run_data.h"

namespace foverig::exports {

/// A run as the CSV of PresentMon 1.x (its README's columns), so that its viewers open it. What we
/// do not know is NA; a present is ours, a display change is the VSync that shows the frame.
std::string presentmon_csv(const report::RunData& run);

}  // namespace foverig::exports
