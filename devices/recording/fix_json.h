#pragma once
// Poses that the tracker camera saw, as JSON for plots (as sample_json.h).
#include "devices/pose_fix.h"
#include "devices/recording/recorder.h"

namespace foverig {

RecordedTopic fix_topic();
/// The buffer is written from its start.
void write_json(std::string& out, const PoseFix& fix);

}  // namespace foverig
