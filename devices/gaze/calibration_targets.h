#pragma once
// Where the points of a calibration lie (DEVICES.md 4.5.3 rule b, 4.5.6), in three measures:
// normalised display (0..1 from the top left), combined POR (x960, x1080 px), and gaze angles in
// degrees (gaze_angles.h) from the point between the eyes.
#include <vector>

#include "devices/gaze/frames.h"
#include "devices/math.h"

namespace foverig::gaze {

/// What CAL_START takes where it is given no targets; normalised. The middle comes first, the rest
/// in rows from the top. Empty for a number of points that SGZ1 does not have.
std::vector<dvec2> default_points(int points);

/// The same pattern, its outermost points `reach_deg` from the middle along each axis. The default
/// ones lie 33 and 39 degrees out, where eyes hardly go (5.3) and noise is five times that of the
/// middle (5.5).
std::vector<dvec2> targets_deg(int points, double reach_deg);

Vec2f por_of(const dvec2& target_deg);
dvec2 target_deg_of(const Vec2f& por_px);

}  // namespace foverig::gaze
