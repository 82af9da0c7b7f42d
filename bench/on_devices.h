#pragma once
#include "bench/options.h"
#include "rig/scenario/scenario.h"

namespace foverig::bench {

/// The scenario on the devices that --devices names. Those of the desk run in real time; a gaze
/// tracker that is not there is simulated.
inline Scenario on_devices(Scenario scenario, const Options& options) {
    scenario.devices = options.devices;
    if (options.devices == "hardware") {
        scenario.clock = "wall";
        scenario.hardware.gaze = "auto";
    }
    return scenario;
}

}  // namespace foverig::bench
