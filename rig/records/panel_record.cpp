#include "rig/records/panel_record.h"

namespace foverig {

PanelRecord panel_record(const std::vector<FrameRecord>& frames) {
    PanelRecord panel;
    const FrameRecord* first = nullptr;
    const FrameRecord* last = nullptr;
    for (const FrameRecord& frame : frames) {
        if (frame.readback_scan_out) ++panel.samples;
        if (frame.dropped() || !frame.vsync) continue;
        if (first == nullptr) first = &frame;
        last = &frame;
    }
    if (first == nullptr || *last->shown_vsync <= *first->shown_vsync) return panel;
    panel.rate_hz = static_cast<double>(*last->shown_vsync - *first->shown_vsync) /
                    to_seconds(*last->vsync - *first->vsync);
    return panel;
}

}  // namespace foverig
