#pragma once
#include "rig/scenario/scenario.h"

namespace foverig {

/// Throws DeviceError where the scenario asks for a device that cannot be opened here, UsageError
/// where its clock is not the devices'. Called before a scene is loaded, which may take long.
void require_devices(const Scenario& scenario);

}  // namespace foverig
