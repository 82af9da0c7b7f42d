#include "rig/records/troubles.h"

namespace foverig {
namespace {

constexpr const char* kControlFailures = "control_failures";
constexpr const char* kRequestsNotSent = "requests_not_sent";

}  // namespace

Troubles by_key(const HeadsetTroubles& headset) {
    return {{kControlFailures, headset.control_failures},
            {kRequestsNotSent, headset.requests_not_sent},
            {"format_switches", headset.format_switches}};
}

Troubles by_key(const GazeTroubles& tracker) {
    return {{"missed_exposures", tracker.missed_exposures},
            {"dropped_by_device", tracker.dropped_by_device},
            {kControlFailures, tracker.control_failures},
            {kRequestsNotSent, tracker.requests_not_sent}};
}

Troubles by_key(const CameraTroubles& camera) {
    return {{"frames_of_no_known_flash", camera.frames_of_no_known_flash},
            {"poses_too_old", camera.poses_too_old}};
}

}  // namespace foverig
