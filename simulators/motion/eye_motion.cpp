#include "simulators/motion/eye_motion.h"

#include "devices/gaze_angles.h"

namespace foverig::motion {

dvec3 direction_of(const dvec2& gaze_deg) {
    return gaze_direction(gaze_deg);
}

dvec2 gaze_of(const dvec3& d) {
    return gaze_angles_deg(d);
}

}  // namespace foverig::motion
