#pragma once
// What is plugged into the graphics cards, as the kernel says in sysfs: headsets too, which it
// keeps from the desktop.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "devices/display/edid.h"

namespace foverig {

struct Connector {
    std::string name;  ///< as in HDMI-A-1; X drivers have names of their own for it
    bool connected = false;
    bool enabled = false;      ///< some mode is set: it shows a picture
    std::optional<Edid> edid;  ///< none: it gives none that can be read
};

/// Sorted by name; empty where there is no graphics card. `drm` is for tests.
std::vector<Connector> list_connectors(const std::filesystem::path& drm = "/sys/class/drm");

}  // namespace foverig
