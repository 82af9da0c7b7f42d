#include "simulators/motion/eye_motion.h"

#include <cmath>

namespace foverig::motion {

dvec3 direction_of(const dvec2& gaze_deg) {
    const double x = glm::radians(gaze_deg.x), y = glm::radians(gaze_deg.y);
    return {std::sin(x) * std::cos(y), std::sin(y), -std::cos(x) * std::cos(y)};
}

dvec2 gaze_of(const dvec3& d) {
    return {glm::degrees(std::atan2(d.x, -d.z)),
            glm::degrees(std::atan2(d.y, std::hypot(d.x, d.z)))};
}

}  // namespace foverig::motion
