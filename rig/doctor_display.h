#pragma once
#include "devices/display/connectors.h"
#include "devices/window/monitors.h"
#include "rig/doctor_devices.h"

namespace foverig {

/// What a person is to know of the desktop's monitors and of the headset's panel among them.
std::vector<DoctorRow> display_rows(const Result<std::vector<window::Monitor>>& monitors,
                                    const std::vector<Connector>& connectors);

/// The same of this machine.
std::vector<DoctorRow> examine_displays();

}  // namespace foverig
