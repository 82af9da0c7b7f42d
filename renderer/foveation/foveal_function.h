#pragma once
#include <cmath>

#include "renderer/math.h"
#include "renderer/vec.h"

namespace foverig {

/// Angle between two directions of any length, from cross and dot: exact near 0 and near pi, where
/// acos loses half its digits.
inline double angle_between_rad(const dvec3& a, const dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Bound of fast_angle_rad's error, polynomial and rounding: 0.003 of a DK2 pixel.
inline constexpr float kFastAngleError_rad = 5.0e-6F;

/// atan2(y, x) for y >= 0 by a polynomial: error below kFastAngleError_rad, no branch, so that a
/// row of pixels goes through it in vectors. Good enough to choose a sampling probability.
RIG_INLINE float fast_angle_rad(float y, float x) {
    const float ax = fabsf(x);
    const float small = min_of(y, ax);
    const float large = max_of(max_of(y, ax), 1.0e-30F);
    const float q = small / large;
    const float q2 = q * q;
    float r =
        q *
        (0.99997726F +
         q2 * (-0.33262347F +
               q2 * (0.19354346F + q2 * (-0.11643287F + q2 * (0.05265332F + q2 * -0.01172120F)))));
    r = y > ax ? 1.57079637F - r : r;
    return x < 0.0F ? 3.14159274F - r : r;
}

/// Probability of sampling a pixel by its eccentricity (Weier 2016 3.1, figure 3): 1 inside r0,
/// p_min outside r1, linear between. With r0 = r1 it is a step.
struct FovealFunction {
    float r0_rad = 0.0F;
    float r1_rad = 0.0F;
    float p_min = 1.0F;
    float slope_per_rad = 0.0F;

    FovealFunction() = default;
    FovealFunction(double r0_deg, double r1_deg, double p_min_)
        : r0_rad(static_cast<float>(glm::radians(r0_deg))),
          r1_rad(static_cast<float>(glm::radians(r1_deg))),
          p_min(static_cast<float>(p_min_)),
          slope_per_rad(r1_rad > r0_rad ? (p_min - 1.0F) / (r1_rad - r0_rad) : 0.0F) {}

    RIG_HD float operator()(float eccentricity_rad) const {
        if (eccentricity_rad <= r0_rad) return 1.0F;
        if (eccentricity_rad >= r1_rad) return p_min;
        return 1.0F + slope_per_rad * (eccentricity_rad - r0_rad);
    }
};

}  // namespace foverig
