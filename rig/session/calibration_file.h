#pragma once
// What `foverig calibrate` writes and a run reads: numbers for people, with their units in their
// names, and the tracker's own calibration as it gave it away.
#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "devices/gaze/calibration.h"
#include "devices/gaze/gaze_source.h"
#include "rig/scenario/scenario.h"

namespace foverig {

struct CalibrationRecord {
    gaze::Info tracker;
    gaze::DeviceStatus status;       ///< after it
    gaze::CalibrationFrame outcome;  ///< of the calibration: accuracy and precision at its points
    std::vector<gaze::CalibrationProcedure::Target> points,
        validation;               ///< the latter may be empty
    std::vector<std::byte> blob;  ///< empty: the tracker keeps it to itself
};

nlohmann::json calibration_json(const CalibrationRecord& record);

/// Of a file's content. Throws InputError, which names the file, where that is no calibration that
/// a tracker takes.
gaze::StoredCalibration calibration_of(const std::string& content, const std::string& name);
/// The same where the file cannot be read.
gaze::StoredCalibration read_calibration(const std::filesystem::path& file);

/// How a scenario wants its gaze tracker set up: throws as read_calibration. A recording is given
/// no calibration and no rate: what was done to its tracker is in its bytes.
gaze::GazeSourceConfig gaze_config(const Scenario& scenario);

}  // namespace foverig
