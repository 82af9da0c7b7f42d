#pragma once
#include <cmath>

#include "devices/math.h"

namespace foverig {

inline double degrees(double rad) {
    return glm::degrees(rad);
}

/// Between two unit directions; accurate for small angles too.
inline double angle_deg(const dvec3& a, const dvec3& b) {
    return degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

/// Of the rotation that leads from one orientation to the other.
inline double angle_deg(const dquat& a, const dquat& b) {
    const dquat turn = glm::conjugate(a) * b;
    return degrees(2.0 * std::atan2(glm::length(dvec3(turn.x, turn.y, turn.z)), std::abs(turn.w)));
}

/// Axis times angle in rad, the short way round.
inline dvec3 rotation_vector(const dquat& turn) {
    const dvec3 v(turn.x, turn.y, turn.z);
    const double sine = glm::length(v);
    if (sine == 0.0) return dvec3(0.0);
    const double angle = 2.0 * std::atan2(sine, std::abs(turn.w));
    return (turn.w < 0.0 ? -angle : angle) / sine * v;
}

}  // namespace foverig
