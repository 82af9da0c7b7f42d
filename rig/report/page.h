#pragma once
#include <string>

#include "rig/report/run_data.h"

namespace foverig::report {

/// report.html: one file, no request to anywhere, whole without scripts too, light and dark.
std::string page(const RunData& run);

}  // namespace foverig::report
