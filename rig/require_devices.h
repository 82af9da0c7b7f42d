#pragma once
#include "rig/scenario/scenario.h"

namespace foverig {

/// Throws DeviceError where the scenario asks for a device that cannot be opened here, UsageError
/// where its clock is not the devices'. Called before a scene is loaded, which may take long.
void require_devices(const Scenario& scenario);

/// For those who show or record its frames: throws UsageError where the scenario's clock is not the
/// see-through camera's.
void require_see_through(const Scenario& scenario);

}  // namespace foverig
