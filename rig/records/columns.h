#pragma once
// The one table of frames.csv: header, values and documentation come from it. Add, never rename.
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "rig/records/frame_record.h"

namespace foverig {

/// Integers stay exact; no value is written as NA.
using Cell = std::variant<std::monostate, std::int64_t, double>;

struct Column {
    std::string id;
    std::string unit;
    std::string definition;
    std::function<Cell(const FrameRecord&)> value;
};

const std::vector<Column>& frame_columns();

/// What only a wall clock knows, so that a fixed cost leaves it out: render_ms, cpu_ms
/// and "pass.<name>_ms" for every pass of these frames, in the order of first appearance.
std::vector<Column> wall_columns(const std::vector<FrameRecord>& frames);

/// Latencies of a frame, in ms; absent where an end is.
std::optional<double> motion_to_photon_ms(const FrameRecord& frame);
std::optional<double> gaze_to_photon_ms(const FrameRecord& frame);
std::optional<double> see_through_to_photon_ms(const FrameRecord& frame);
std::optional<double> warp_to_photon_ms(const FrameRecord& frame);
std::optional<double> imu_transport_ms(const FrameRecord& frame);
std::optional<double> gaze_transport_ms(const FrameRecord& frame);
std::optional<double> readback_ms(const FrameRecord& frame);

/// Work of a frame: begin to present, without waiting for the display.
double frame_time_ms(const FrameRecord& frame);

}  // namespace foverig
