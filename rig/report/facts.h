#pragma once
#include <string>

#include "rig/report/run_data.h"

namespace foverig::report {

/// Tables of what is in the summary: the effect plan, the devices, memory and rays, the scenario.
std::string plan_table(const RunData& run);
std::string device_table(const RunData& run);
std::string resource_table(const RunData& run);
std::string scenario_listing(const RunData& run);

}  // namespace foverig::report
