#pragma once
// The monitors that the desktop offers, and which of them is the headset.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "devices/display/dk2_optics.h"
#include "devices/result.h"

namespace foverig::window {

struct Monitor {
    std::string name;    ///< on X the output's: HDMI-1
    SizePx mode;         ///< what it shows now
    int refresh_hz = 0;  ///< 0: not told (Xvfb)
    int width_mm = 0, height_mm = 0;
};

/// "HDMI-1 (1920x1080 at 75 Hz, 126x71 mm)".
std::string text_of(const Monitor& monitor);

/// The one that looks like a DK2's panel: by name, or 1080x1920 or 1920x1080 pixels on 126 mm x 71
/// mm (DEVICES.md 2.1) within 15 %.
std::optional<std::size_t> dk2_among(std::span<const Monitor> monitors);

/// `name`, or where it is empty the DK2's. Not found: the error lists what there is.
Result<std::size_t> choose_monitor(std::span<const Monitor> monitors, const std::string& name);

/// Opens and closes the connection to the desktop; not while a Window is open. The error says what
/// GLFW says: no DISPLAY, say.
Result<std::vector<Monitor>> list_monitors();

}  // namespace foverig::window
