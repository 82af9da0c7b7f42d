#pragma once
#include <string>

#include "rig/report/run_data.h"

namespace foverig::report {

/// The scene's name, without its folder, and the pipeline.
std::string title(const RunData& run);

/// Title, the answer in one sentence, the numbers that matter, and what was measured on what.
std::string overview(const RunData& run);

}  // namespace foverig::report
