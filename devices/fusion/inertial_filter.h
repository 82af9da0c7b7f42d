#pragma once
// Position, velocity, orientation and both sensors' biases of an inertial sensor: an error-state
// Kalman filter (Sola, "Quaternion kinematics for the error-state Kalman filter", 2017, sections 5
// and 6; rotation errors in the body's frame). Knows nothing of cameras, delays or clocks.
#include <optional>

#include "devices/matrix.h"
#include "devices/rigid_pose.h"

namespace foverig {

/// Densities, continuous; bias walks too.
struct InertialNoise {
    double gyro_rad_sqrt_s = 2e-4;   ///< twice an MPU-6500's (DEVICES.md 6.2) ...
    double gyro_scale = 3e-3;        ///< ... and this share of the rate: scale, alignment
    double accel_m_s_sqrt_s = 1e-2;  ///< three times the chip's
    double gyro_walk_rad_s_sqrt_s = 5e-5;
    double accel_walk_m_s2_sqrt_s = 1e-3;
};

/// One instant of the sensor, body frame.
struct Inertial {
    dvec3 gyro_rad_s{0};
    dvec3 accel_m_s2{0};
    /// What the chip's warmth has added to the gyro's bias, as far as another knows, since any
    /// instant that all have in common: only differences count.
    dvec3 bias_by_warmth_rad_s{0};
};

class InertialFilter {
  public:
    /// Order of the error's parts, three each.
    enum Part : std::size_t {
        kPosition = 0,
        kVelocity = 3,
        kTurn = 6,
        kAccelBias = 9,
        kGyroBias = 12
    };
    using Covariance = Matrix<15, 15>;

    struct State {
        dvec3 position_m{0};  ///< world
        dvec3 velocity_m_s{0};
        dquat world_from_body{1, 0, 0, 0};
        dvec3 accel_bias_m_s2{0}, gyro_bias_rad_s{0};
        Covariance covariance;

        RigidPose pose() const { return {world_from_body, position_m}; }
    };

    /// At rest somewhere, with the uncertainty of a fix and of a worn chip's biases.
    static State start(const RigidPose& world_from_body, const dvec3& velocity_m_s);

    /// Over `dt_s` between two instants of the sensor.
    static void advance(State& state, const Inertial& before, const Inertial& after, double dt_s,
                        const InertialNoise& noise);

    /// A measured pose. `covariance`: rotation in the body's frame, then position in the world's.
    /// Returns the squared distance that the filter expected it within (chi-square of 6), and
    /// leaves the state alone where that is above `gate`.
    static double measure_pose(State& state, const RigidPose& world_from_body,
                               const Matrix<6, 6>& covariance, double gate);

    /// A point of the body, `lever_m` from the sensor, that stands still but for `sigma_m_s`.
    static void measure_rest(State& state, const dvec3& rate_rad_s, const dvec3& lever_m,
                             double sigma_m_s);
};

}  // namespace foverig
