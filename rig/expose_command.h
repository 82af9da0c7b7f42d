#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "rig/failure.h"
#include "rig/scenario/scenario.h"

namespace foverig {

struct ExposeRequest {
    std::string device;                           ///< dk2, camera or gaze
    std::string via = "usbip";                    ///< or uhid, for a dk2
    Scenario scenario;                            ///< its motion, faults and seed; or a recording
    std::optional<std::filesystem::path> record;  ///< keeps what went over
};

/// Publishes a simulated or recorded device as one of the kernel's until Ctrl-C, the recording's
/// end, or the scenario's `seconds` where they are given. Throws DeviceError where the kernel takes
/// none.
ExitCode expose_command(const ExposeRequest& request);

}  // namespace foverig
