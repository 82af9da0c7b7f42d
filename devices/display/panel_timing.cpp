#include "devices/display/panel_timing.h"

namespace foverig {
namespace {

// Half way to the next mode, 72 Hz: a measured 75 is hardly ever exactly that.
constexpr double kLowPersistenceFrom_hz = 73.5;

}  // namespace

PanelTiming PanelTiming::at(double refresh_hz) {
    PanelTiming timing;
    timing.refresh_hz = refresh_hz;
    if (refresh_hz < kLowPersistenceFrom_hz) timing.persistence_rows = timing.total_rows;
    return timing;
}

HostTime PanelTiming::written(HostTime vsync, double x_px) const {
    const double share = (width_px - x_px) / width_px;
    return vsync + first_row_delay + from_seconds(share * to_seconds(scan_out()));
}

HostTime PanelTiming::photon(HostTime vsync, double x_px) const {
    return written(vsync, x_px) + pixel_settle + persistence() / 2;
}

HostTime PanelTiming::photon(HostTime vsync, Eye eye) const {
    return photon(vsync, width_px * (eye == Eye::left ? 0.25 : 0.75));
}

}  // namespace foverig
