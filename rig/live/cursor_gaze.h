#pragma once
#include "devices/display/eye_map.h"
#include "devices/display/panel_view.h"
#include "simulators/motion/eye_motion.h"

namespace foverig {

/// How far away a cursor is taken to lie: the tracker's mapping distance (DEVICES.md 4.1).
inline constexpr double kCursorDistance_m = 1.5;

/// Two eyes that look at what `place` shows to its eye: the map gives that eye's
/// direction (green), and the other eye meets it at kCursorDistance_m.
motion::EyeState looking_at(const EyePlace& place, const EyeMap& map);

}  // namespace foverig
