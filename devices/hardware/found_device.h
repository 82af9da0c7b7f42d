#pragma once
// Devices that are plugged in, whether or not they can be opened.
#include <string>
#include <vector>

#include "devices/hardware/identity.h"
#include "devices/result.h"

namespace foverig::hardware {

struct FoundDevice {
    std::string path;              ///< of its node in /dev
    std::string serial;            ///< empty: unknown, as where the node may not be opened
    std::optional<Error> problem;  ///< forbidden, busy or io: why it cannot be opened
};

/// Headsets, of hidraw.
std::vector<FoundDevice> find_headsets();
/// Gaze trackers, of usbfs. They are opened for a moment, but nothing is sent.
std::vector<FoundDevice> find_gaze_trackers(const UsbId& id);

/// Why a node cannot be opened, in one sentence that says what to do; nothing where it can.
std::optional<Error> opening_problem(const std::string& path);
Error forbidden(const std::string& path);

/// The one to open: of the serial, or the only one. Errors: not_found, invalid_data (which of
/// several?). `kind` and `looked_for` are for the sentence: "headset", "Rift DK2, USB 2833:0021".
Result<FoundDevice> choose(const std::vector<FoundDevice>& found, const std::string& serial,
                           const std::string& kind, const std::string& looked_for);

}  // namespace foverig::hardware
