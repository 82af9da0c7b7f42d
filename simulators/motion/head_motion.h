#pragma once
// Ground truth of the head: a pure function of time.
#include "devices/math.h"
#include "simulators/motion/jet.h"

namespace foverig::motion {

/// The pose of the point midway between the eyes and its derivatives. World: x right, y up, z back,
/// metres, origin where that point is when the head is upright and looks ahead. Head frame: the
/// same axes, fixed to the head.
struct HeadState {
    dquat world_from_head{1.0, 0.0, 0.0, 0.0};
    dvec3 position_m{0.0};                   ///< world
    dvec3 angular_velocity_rad_s{0.0};       ///< head frame
    dvec3 angular_acceleration_rad_s2{0.0};  ///< head frame
    dvec3 acceleration_m_s2{0.0};            ///< world, without gravity
};

class HeadMotion {
  public:
    virtual ~HeadMotion() = default;
    virtual HeadState at(double t_s) const = 0;
};

/// What an accelerometer at `lever_m` (head frame, from the point between the eyes) feels, in the
/// head frame: specific force, so +g upwards at rest.
dvec3 specific_force(const HeadState& head, const dvec3& lever_m, double gravity_m_s2);

/// Yaw (about y), then pitch (about x), then roll (about z), in radians, turning about the neck.
HeadState head_from_angles(const Jet& yaw_rad, const Jet& pitch_rad, const Jet& roll_rad);

/// Fills position and acceleration of a head that turns about a neck that stays where it is.
void hang_on_neck(HeadState& head);

}  // namespace foverig::motion
