#pragma once
#include <vector>

#include "devices/display/eye_map.h"

namespace foverig {

/// Where the cone of `radius_deg` around `gaze` (unit, eye frame, ahead) comes through the lens:
/// NDC of the eye's half of the panel, a closed line. Parts behind the eye are left out.
std::vector<dvec2> gaze_ring(Eye eye, const dvec3& gaze, double radius_deg, const EyeMap& map);

}  // namespace foverig
