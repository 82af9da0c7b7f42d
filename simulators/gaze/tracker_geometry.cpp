#include "simulators/gaze/tracker_geometry.h"

namespace foverig {
namespace {

constexpr double kTanUp = 1.331603, kTanTemporal = 1.058657, kTanNasal = 1.092368;
constexpr double kEyeWidth_px = 960.0, kEyeHeight_px = 1080.0;

}  // namespace

dvec3 cyclops_base_mm() {
    return {0.0, 0.0, kEyeBehindLens_mm};
}

dvec3 eye_base_mm(Side side) {
    return {side == Side::left ? -0.5 * kIod_mm : 0.5 * kIod_mm, 0.0, kEyeBehindLens_mm};
}

dvec3 eye_direction(Side side, const motion::EyeState& state) {
    const dvec3 target_mm = cyclops_base_mm() + 1000.0 * state.vergence_m * state.direction;
    return glm::normalize(target_mm - eye_base_mm(side));
}

dvec2 por_in_eye_px(Side side, const dvec3& direction) {
    const double tan_left = side == Side::left ? kTanTemporal : kTanNasal;
    const dvec2 tangent = dvec2(direction.x, direction.y) / -direction.z;
    return {(tangent.x + tan_left) / (kTanTemporal + kTanNasal) * kEyeWidth_px,
            (kTanUp - tangent.y) / (2.0 * kTanUp) * kEyeHeight_px};
}

gaze::Vec3f on_wire(const dvec3& v) {
    return {static_cast<float>(-v.x), static_cast<float>(v.y), static_cast<float>(-v.z)};
}

}  // namespace foverig
