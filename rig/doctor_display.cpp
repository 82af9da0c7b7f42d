#include "rig/doctor_display.h"

#include <fmt/format.h>

#include <algorithm>

namespace foverig {
namespace {

std::string said_of(const Result<std::vector<window::Monitor>>& monitors) {
    if (!monitors) return monitors.error().text + ": --display window cannot be used here";
    std::string all;
    for (const window::Monitor& monitor : *monitors)
        all += (all.empty() ? "" : "; ") + window::text_of(monitor);
    return all.empty() ? "the desktop has none" : all;
}

/// As most X drivers call it: the kernel's HDMI-A-1 is their HDMI-1.
std::string x_output(std::string connector) {
    constexpr std::string_view kKernels = "HDMI-A-";
    if (connector.starts_with(kKernels)) connector.replace(0, kKernels.size(), "HDMI-");
    return connector;
}

std::string said_of_panel(const Result<std::vector<window::Monitor>>& monitors,
                          const std::vector<Connector>& connectors) {
    if (monitors) {
        if (const auto dk2 = window::dk2_among(*monitors))
            return window::text_of((*monitors)[*dk2]) + ": ready for --display headset";
    }
    const auto plugged = std::find_if(connectors.begin(), connectors.end(), [](const Connector& c) {
        return c.connected && c.edid && is_oculus(*c.edid);
    });
    if (plugged == connectors.end()) return "none seen (EDID maker OVR)";
    const std::string output = x_output(plugged->name);
    return fmt::format(
        "{} {} is plugged in at {}, but is none of the desktop's monitors: Linux marks headsets as "
        "non-desktop; on X, type: xrandr --output {} --set non-desktop 0 && xrandr --output {} "
        "--auto (xrandr --prop lists outputs under its own names)",
        plugged->edid->maker, plugged->edid->name, plugged->name, output, output);
}

}  // namespace

std::vector<DoctorRow> display_rows(const Result<std::vector<window::Monitor>>& monitors,
                                    const std::vector<Connector>& connectors) {
    return {{"monitors", said_of(monitors)},
            {"headset panel", said_of_panel(monitors, connectors)}};
}

std::vector<DoctorRow> examine_displays() {
    return display_rows(window::list_monitors(), list_connectors());
}

}  // namespace foverig
