#pragma once
#include <string>

#include "rig/report/run_data.h"

namespace foverig::report {

/// The strip of every frame that zooms, where there are scripts; beside the static one, whose place
/// it takes on a screen. Empty where the build has no uPlot, and for runs too long to draw so.
std::string live_strip(const RunData& run);

}  // namespace foverig::report
