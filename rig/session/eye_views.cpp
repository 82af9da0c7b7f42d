#include "rig/session/eye_views.h"

namespace foverig {

EyeInput EyeViews::eye(Eye eye, const Stand& stand, const Pose& pose, const dvec3& gaze) const {
    const TangentFrustum frustum = optics_.frustum(eye);
    const dvec3 aside(eye == Eye::left ? -kHalfIpd_m : kHalfIpd_m, 0.0, 0.0);
    const dvec3 moved = pose.position_m + pose.world_from_head * aside;
    EyeInput input;
    input.view = {
        .width_px = display_.eye_width_px,
        .height_px = display_.eye_height_px,
        .tan_left = static_cast<float>(frustum.left),
        .tan_right = static_cast<float>(frustum.right),
        .tan_down = static_cast<float>(frustum.down),
        .tan_up = static_cast<float>(frustum.up),
        .position_m = vec3(stand.position_m + stand.world_from_body * moved),
        .world_from_eye = mat3(stand.world_from_body * glm::mat3_cast(pose.world_from_head))};
    input.gaze = vec3(gaze);
    return input;
}

}  // namespace foverig
