#include "simulators/motion/head_motion.h"

#include <cmath>

#include "devices/head_geometry.h"

namespace foverig::motion {
namespace {

/// Turns `v` by minus `roll` about z: from the pitched frame into the rolled one.
dvec3 into_rolled(const dvec3& v, double roll_rad) {
    const double c = std::cos(roll_rad), s = std::sin(roll_rad);
    return {v.x * c + v.y * s, -v.x * s + v.y * c, v.z};
}

/// Acceleration of a point fixed to the head relative to the head's origin, head frame.
dvec3 lever_acceleration(const HeadState& head, const dvec3& lever_m) {
    const dvec3& omega = head.angular_velocity_rad_s;
    return glm::cross(head.angular_acceleration_rad_s2, lever_m) +
           glm::cross(omega, glm::cross(omega, lever_m));
}

}  // namespace

dvec3 specific_force(const HeadState& head, const dvec3& lever_m, double gravity_m_s2) {
    const dvec3 world = head.acceleration_m_s2 + dvec3(0.0, gravity_m_s2, 0.0);
    return glm::conjugate(head.world_from_head) * world + lever_acceleration(head, lever_m);
}

HeadState head_from_angles(const Jet& yaw, const Jet& pitch, const Jet& roll) {
    HeadState head;
    head.world_from_head = glm::angleAxis(yaw.value, dvec3(0, 1, 0)) *
                           glm::angleAxis(pitch.value, dvec3(1, 0, 0)) *
                           glm::angleAxis(roll.value, dvec3(0, 0, 1));
    const double c = std::cos(pitch.value), s = std::sin(pitch.value);
    const dvec3 pitched(pitch.rate, yaw.rate * c, -yaw.rate * s);
    const dvec3 pitched_rate(pitch.acceleration, yaw.acceleration * c - yaw.rate * pitch.rate * s,
                             -yaw.acceleration * s - yaw.rate * pitch.rate * c);
    const dvec3 rolled = into_rolled(pitched, roll.value);
    head.angular_velocity_rad_s = rolled + dvec3(0, 0, roll.rate);
    head.angular_acceleration_rad_s2 = into_rolled(pitched_rate, roll.value) +
                                       dvec3(0, 0, roll.acceleration) -
                                       glm::cross(dvec3(0, 0, roll.rate), rolled);
    hang_on_neck(head);
    return head;
}

void hang_on_neck(HeadState& head) {
    head.position_m = head.world_from_head * kEyesFromNeck_m - kEyesFromNeck_m;
    head.acceleration_m_s2 = head.world_from_head * lever_acceleration(head, kEyesFromNeck_m);
}

}  // namespace foverig::motion
