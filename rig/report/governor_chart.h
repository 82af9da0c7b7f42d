#pragma once
#include <string>

#include "rig/report/run_data.h"

namespace foverig::report {

/// Which setting the governor chose frame by frame, as steps, and what each is; empty without one.
std::string governor_chart(const RunData& run);

}  // namespace foverig::report
