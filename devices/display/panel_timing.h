#pragma once
// When the DK2 panel's columns light up (DEVICES.md 2.3). The portrait panel scans top to bottom,
// which is right to left in landscape: right eye first. Row time and persistence are the firmware's
// (1933 rows a period); the delay of the first row is LibOVR's.
#include "devices/time.h"

namespace foverig {

enum class Eye { left = 0, right = 1 };

struct PanelTiming {
    double refresh_hz = 75;
    int width_px = 1920, height_px = 1080;  ///< landscape
    int total_rows = 1933;                  ///< of the portrait scan, blanking included
    int persistence_rows = 435;             ///< rows lit at once: 22.5 %
    Nanoseconds first_row_delay{27300};     ///< vsync to the first row
    Nanoseconds pixel_settle{100000};

    /// The panel at a rate, measured or nominal; below its 75 Hz mode the firmware falls back to
    /// full persistence.
    static PanelTiming at(double refresh_hz);

    Nanoseconds period() const { return from_seconds(1 / refresh_hz); }
    /// First to last column: 1920 rows.
    Nanoseconds scan_out() const { return from_seconds(width_px / (refresh_hz * total_rows)); }
    Nanoseconds persistence() const {
        return from_seconds(persistence_rows / (refresh_hz * total_rows));
    }

    /// When column `x_px` (0 is the left edge, 1920 the right, landscape) is written.
    HostTime written(HostTime vsync, double x_px) const;
    /// The middle of its light: written + settle + half the persistence.
    HostTime photon(HostTime vsync, double x_px) const;
    /// The photon time of an eye's middle column, for which poses and gaze are predicted.
    HostTime photon(HostTime vsync, Eye eye) const;
};

}  // namespace foverig
