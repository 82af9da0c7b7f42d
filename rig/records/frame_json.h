#pragma once
// A frame as JSON, for recordings: the columns of frames.csv.
#include "rig/records/columns.h"

namespace foverig {

/// {"frame": 0, "begin_ns": ...}; what is absent is null.
std::string frame_json(const FrameRecord& frame);

/// The JSON schema of that, with each column's unit and definition.
std::string frame_json_schema();

}  // namespace foverig
