#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "rig/records/frame_record.h"

namespace foverig {

/// The panel as a device that answers: what `summary.devices.panel` says of it.
struct PanelRecord {
    std::uint64_t samples = 0;      ///< frames whose corner pixel was read back (1.7)
    std::optional<double> rate_hz;  ///< scan-outs over the time between the first and the last
};

PanelRecord panel_record(const std::vector<FrameRecord>& frames);

}  // namespace foverig
