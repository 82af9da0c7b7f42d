#pragma once
#include "devices/math.h"

namespace foverig {

/// Takes points of one frame to another: rotation first.
struct RigidPose {
    dquat rotation{1, 0, 0, 0};
    dvec3 translation_m{0};

    dvec3 operator*(const dvec3& point_m) const { return rotation * point_m + translation_m; }
    RigidPose operator*(const RigidPose& inner) const {
        return {glm::normalize(rotation * inner.rotation), *this * inner.translation_m};
    }
    RigidPose inverse() const {
        const dquat back = glm::conjugate(rotation);
        return {back, back * -translation_m};
    }
};

}  // namespace foverig
