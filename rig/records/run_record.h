#pragma once
// One whole run: what the summary and the report are computed from.
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "devices/source.h"
#include "renderer/effects/plan.h"
#include "rig/records/frame_record.h"

namespace foverig {

struct DeviceRecord {
    std::string name;
    SourceCounts counts;
    std::optional<double> rate_hz;  ///< samples over the time they were taken in
};

/// What became of session.mcap.
struct RecordingRecord {
    std::uint64_t messages = 0;
    std::uint64_t dropped = 0;
    std::map<std::string, std::uint64_t> dropped_of;  ///< by topic, where any were
    std::uint64_t bytes = 0;
};

struct RunRecord {
    std::vector<FrameRecord> frames;
    std::vector<DeviceRecord> devices;
    std::vector<PlannedEffect> plan;
    std::string pipeline;
    std::string backend;
    std::uint64_t backend_bytes = 0;
    double rate_hz = 75.0;     ///< of the display
    bool fixed_cost = false;   ///< lockstep clock at a fixed cost
    bool interrupted = false;  ///< ended early by Ctrl-C
    std::optional<RecordingRecord> recording;
};

}  // namespace foverig
