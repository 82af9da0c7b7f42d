#pragma once
#include <string>

#include "rig/session/calibration_file.h"

namespace foverig {

/// What a calibration came to, for a terminal: a line, and a table where it was validated.
std::string calibration_text(const CalibrationRecord& record);

}  // namespace foverig
