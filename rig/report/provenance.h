#pragma once
#include <string>

#include "rig/report/run_data.h"

namespace foverig::report {

/// What of the run was simulated, recorded (of what) or real, whether an ordinary screen stood for
/// the panel, which faults were injected, and whether its times were measured: sentences, plain
/// text. A run folder that does not say where a device's bytes came from is silent about that
/// device.
std::string provenance(const RunData& run);

}  // namespace foverig::report
