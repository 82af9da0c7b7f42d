#pragma once
#include <cmath>

#include "devices/math.h"

namespace foverig {

/// Gaze angles in degrees, x to the right and y upwards, as a unit direction in the head's frame.
inline dvec3 gaze_direction(const dvec2& gaze_deg) {
    const double x = glm::radians(gaze_deg.x), y = glm::radians(gaze_deg.y);
    return {std::sin(x) * std::cos(y), std::sin(y), -std::cos(x) * std::cos(y)};
}

/// And back.
inline dvec2 gaze_angles_deg(const dvec3& d) {
    return {glm::degrees(std::atan2(d.x, -d.z)),
            glm::degrees(std::atan2(d.y, std::hypot(d.x, d.z)))};
}

/// Between two directions of any length.
inline double angle_between_deg(const dvec3& a, const dvec3& b) {
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

}  // namespace foverig
