#pragma once
// Two eyes behind the DK2's lenses and what a tracker says of them: head frame in millimetres here
// (x right, y up, z back, origin midway between the lens centres, in their plane).
#include "devices/gaze/frames.h"
#include "simulators/motion/eye_motion.h"

namespace foverig {

/// The numbers of the golden frame in DEVICES.md 4.5.3.
inline constexpr double kIod_mm = 64.0;
inline constexpr double kEyeBehindLens_mm = 22.0;  ///< eye's centre
inline constexpr double kPupilAhead_mm = 12.0;     ///< of the eye's centre
inline constexpr double kPupilRadius_mm = 2.0;
inline constexpr double kLensDistance_mm = 10.0;
inline constexpr double kScreenDistance_mm = 50.0;

enum class Side { left = 0, right = 1 };

/// The eye's centre.
dvec3 eye_base_mm(Side side);
dvec3 cyclops_base_mm();

/// Unit direction from an eye to where the ray between the eyes has come `vergence_m` far.
dvec3 eye_direction(Side side, const motion::EyeState& state);

/// Point of regard on the eye's half of the panel before lens distortion: 0..960, 0..1080 px from
/// the top left, through the DK2's exact frustum (DEVICES.md 2.2). `direction` looks ahead.
dvec2 por_in_eye_px(Side side, const dvec3& direction);

/// Into the wire's frame: x left, y up, z forward.
gaze::Vec3f on_wire(const dvec3& v);

}  // namespace foverig
