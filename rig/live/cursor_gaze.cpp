#include "rig/live/cursor_gaze.h"

#include "simulators/gaze/tracker_geometry.h"

namespace foverig {

motion::EyeState looking_at(const EyePlace& place, const EyeMap& map) {
    const dvec2 tangent = map.tangent(place.eye, place.ndc);
    const dvec3 direction = glm::normalize(dvec3(tangent, -1.0));
    const Side side = place.eye == Eye::left ? Side::left : Side::right;
    const dvec3 target_mm = eye_base_mm(side) + 1000.0 * kCursorDistance_m * direction;
    const dvec3 from_between_mm = target_mm - cyclops_base_mm();
    return {.direction = glm::normalize(from_between_mm),
            .vergence_m = 1e-3 * glm::length(from_between_mm)};
}

}  // namespace foverig
