#pragma once
// What goes wrong in ways that only one kind of device has; by_key says how records call each.
#include <cstdint>
#include <map>
#include <string>

namespace foverig {

/// Name (as a key of devices.NAME.troubles of summary.json) and count.
using Troubles = std::map<std::string, std::uint64_t>;

struct HeadsetTroubles {
    std::uint64_t control_failures = 0;
    std::uint64_t requests_not_sent = 0;  ///< as the device had let one run out of time
    std::uint64_t format_switches = 0;    ///< of its input report
};

struct GazeTroubles {
    std::uint64_t missed_exposures = 0;
    std::uint64_t dropped_by_device = 0;
    std::uint64_t control_failures = 0;
    std::uint64_t requests_not_sent = 0;  ///< as the device had let one run out of time
};

struct CameraTroubles {
    std::uint64_t frames_of_no_known_flash = 0;
    std::uint64_t poses_too_old = 0;  ///< to begin with, or for the filter
};

Troubles by_key(const HeadsetTroubles& headset);
Troubles by_key(const GazeTroubles& tracker);
Troubles by_key(const CameraTroubles& camera);

}  // namespace foverig
