#pragma once
// Rotation vectors (axis times angle, radians) and unit quaternions.
#include <cmath>

#include "devices/math.h"

namespace foverig {

/// Quaternion of a rotation vector; series near zero, so that nothing is divided by a small angle.
inline dquat exp_map(const dvec3& rotation_rad) {
    const double angle2 = glm::dot(rotation_rad, rotation_rad);
    double w = 0, scale = 0;
    if (angle2 < 1e-4) {
        w = 1 - angle2 / 8 * (1 - angle2 / 48);
        scale = 0.5 - angle2 / 48 * (1 - angle2 / 80);
    } else {
        const double angle = std::sqrt(angle2);
        w = std::cos(0.5 * angle);
        scale = std::sin(0.5 * angle) / angle;
    }
    return dquat(w, rotation_rad * scale);
}

/// Rotation vector of a unit quaternion, angle in 0..pi.
inline dvec3 log_map(const dquat& q) {
    const dvec3 v = q.w < 0 ? dvec3(-q.x, -q.y, -q.z) : dvec3(q.x, q.y, q.z);
    const double length = glm::length(v);
    const double w = std::abs(q.w);
    return length < 1e-8 ? v * 2.0 / w : v * (2 * std::atan2(length, w) / length);
}

/// Angle between two orientations, radians.
inline double angle_between(const dquat& a, const dquat& b) {
    return glm::length(log_map(glm::conjugate(a) * b));
}

/// Rotation vector over `dt_s` of a body rate that goes linearly from `start` to `end`: fourth
/// order; the cross product is the coning that a mean rate would miss.
inline dvec3 rotation_of_rates(const dvec3& start_rad_s, const dvec3& end_rad_s, double dt_s) {
    return 0.5 * dt_s * (start_rad_s + end_rad_s) +
           dt_s * dt_s / 12 * glm::cross(start_rad_s, end_rad_s);
}

}  // namespace foverig
