#pragma once
// Where the eyes and the sensor sit on a head that wears a DK2. Head frame: x right, y up, z back.
#include "devices/math.h"

namespace foverig {

inline constexpr double kGravity_m_s2 = 9.80665;

/// From the neck's pivot to the point midway between the eyes (DEVICES.md 2.1).
inline constexpr dvec3 kEyesFromNeck_m{0.0, 0.075, -0.0805};

/// From that point to the IMU (DEVICES.md 1.8.5 with 1.2.2). Own choice: the headset's origin is
/// taken as the point between the eyes, which no document states.
inline constexpr dvec3 kImuFromEyes_m{-0.0671, -0.0241, -0.008545};

}  // namespace foverig
