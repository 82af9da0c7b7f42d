#include "rig/require_devices.h"

#include "rig/failure.h"

namespace foverig {

void require_devices(const Scenario& scenario) {
    if (scenario.devices == "hardware")
        throw DeviceError(
            "devices = hardware: this build has no driver for a headset or a gaze tracker on the "
            "desk; use --devices sim or replay:FILE");
    if (scenario.display.kind == "headset")
        throw DeviceError(
            "display.kind = headset: this build cannot drive a headset's panel; use --display "
            "virtual");
}

}  // namespace foverig
