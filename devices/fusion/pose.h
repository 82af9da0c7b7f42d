#pragma once
#include "devices/math.h"
#include "devices/time.h"

namespace foverig {

/// The head at an instant. World: x right, y up, z back of the first pose; y is against gravity.
struct Pose {
    HostTime time{};
    dquat world_from_head{1, 0, 0, 0};
    dvec3 position_m{0};              ///< midway between the eyes, 0 when upright
    dvec3 angular_velocity_rad_s{0};  ///< in the head's frame, bias removed
    bool stale = false;               ///< rests on no recent sample, or on a long gap
};

}  // namespace foverig
