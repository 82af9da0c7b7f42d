#include "rig/records/troubles.h"

namespace foverig {
namespace {

constexpr const char* kControlFailures = "control_failures";

}  // namespace

Troubles by_key(const HeadsetTroubles& headset) {
    return {{kControlFailures, headset.control_failures},
            {"format_switches", headset.format_switches}};
}

Troubles by_key(const GazeTroubles& tracker) {
    return {{"missed_exposures", tracker.missed_exposures},
            {"dropped_by_device", tracker.dropped_by_device},
            {kControlFailures, tracker.control_failures}};
}

Troubles by_key(const CameraTroubles& camera) {
    return {{"frames_of_no_known_flash", camera.frames_of_no_known_flash}};
}

}  // namespace foverig
