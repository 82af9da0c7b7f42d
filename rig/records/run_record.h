#pragma once
// One whole run: what the summary and the report are computed from.
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "devices/source.h"
#include "renderer/effects/plan.h"
#include "rig/identity/processor_use.h"
#include "rig/records/frame_record.h"
#include "rig/records/troubles.h"

namespace foverig {

/// A device was not there.
struct Outage {
    HostTime lost{};
    std::optional<HostTime> back;  ///< none: not before the run's end
    std::string why;
};

/// Where a device's bytes come from.
enum class Origin { simulated, recorded, hardware };

/// "simulated", "recorded", "hardware".
const char* name_of(Origin origin);

struct DeviceRecord {
    std::string name;
    SourceCounts counts;
    std::optional<double> rate_hz;  ///< samples over the time they were taken in
    std::vector<Outage> outages{};
    Troubles troubles{};
    Origin origin = Origin::simulated;
    /// Of a recorded device: what it was when it was recorded; none: the recording does not say.
    std::optional<Origin> recorded_from{};
};

/// A window that showed the frames.
struct DisplayRecord {
    std::string shown_on{};        ///< monitor, or a window's size
    bool on_headset = false;       ///< it filled the headset's panel, not an ordinary screen
    bool vsync_measured = false;   ///< the display paces the frames; else our own clock does
    double vsync_error_ms = 0.0;   ///< one way; a delay that never changes is not in it
    std::uint64_t hud_frames = 0;  ///< frames that paid for the HUD
};

/// One of the settings that a governor chose among.
struct GovernedSetting {
    std::string text{};             ///< "foveation.p_min = 0.05, ..."
    double ms = 0.0;                ///< what it cost where it was measured
    std::optional<double> error{};  ///< what it was off the reference there; of the front's error
};

struct GovernorRecord {
    std::vector<GovernedSetting> settings;  ///< cheapest first
    std::string error_name;                 ///< of the errors; empty: they are not known
    double limit_ms = 0.0;                  ///< frames are to stay below
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
    std::optional<GovernorRecord> governor;
    std::optional<DisplayRecord> display;         ///< none: a virtual panel
    std::optional<ProcessorUse> processor_use{};  ///< while it ran; none: the system does not tell
};

}  // namespace foverig
