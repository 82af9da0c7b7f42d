#pragma once
#include "metrics/plane.h"

namespace foverig::metrics {

/// Half as wide and high (of odd sizes one more half): a 5-tap filter of 0.05, 0.25, 0.4, 0.25,
/// 0.05 on every second pixel (Burt and Adelson 1983), borders mirrored, as FovVideoVDP has it. At
/// least 2 pixels each way.
Plane reduced(const Plane& plane);

/// Back to `width_px` x `height_px`, of which `plane` is the half; beyond its border its last
/// sample goes on.
Plane expanded(const Plane& plane, int width_px, int height_px);

}  // namespace foverig::metrics
