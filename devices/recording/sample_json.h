#pragma once
// Decoded samples as JSON, in the form that Foxglove and PlotJuggler plot.
#include "devices/gaze/gaze_sample.h"
#include "devices/imu_sample.h"
#include "devices/recording/recorder.h"

namespace foverig {

/// Schema and topic of what the functions below write.
RecordedTopic imu_topic();
RecordedTopic gaze_topic();

/// What was not measured is null. The buffer is written from its start.
void write_json(std::string& out, const ImuSample& sample);
void write_json(std::string& out, const GazeSample& sample);

}  // namespace foverig
