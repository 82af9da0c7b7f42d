#pragma once
#include <optional>
#include <string_view>

#include "rig/records/run_record.h"
#include "simulators/replay/recording.h"

namespace foverig {

/// What a device ("dk2", "gaze", "camera", "see_through") of the recording was, simulated or
/// hardware: as its topic says or, where it was recorded before topics did, as its scenario asked.
/// None: neither tells.
std::optional<Origin> recorded_origin(const Recording& recording, std::string_view device);

}  // namespace foverig
