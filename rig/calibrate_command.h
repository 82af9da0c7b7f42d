#pragma once
#include <filesystem>

#include "rig/failure.h"
#include "rig/scenario/scenario.h"

namespace foverig {

struct CalibrateRequest {
    Scenario scenario;
    int points = 5;           ///< 0, 1, 3, 5, 9 or 13; 0 forgets the calibration
    double reach_deg = 16.0;  ///< of the outermost targets, along each axis
    bool validate = false;
    std::filesystem::path out = "calibration.json";
};

/// Calibrates the scenario's gaze tracker: check_failed where the tracker refuses, interrupted
/// where somebody ended it; then nothing is written and the former calibration stands. Throws
/// DeviceError where the tracker is missing or was unplugged.
ExitCode calibrate_command(const CalibrateRequest& request);

}  // namespace foverig
