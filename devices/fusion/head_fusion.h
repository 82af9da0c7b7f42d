#pragma once
// Orientation from gyro integration with a slow pull towards gravity, and a neck for position
// (DEVICES.md 2.1, 3.1; LaValle et al. 2014). What the pull must go on making good is the gyro's
// offset, as far as gravity sees it: a head that never rests teaches it too (TiltGains). Yaw has no
// reference and keeps what the gyro says.
#include <deque>
#include <optional>

#include "devices/fusion/gyro_bias.h"
#include "devices/fusion/pose.h"
#include "devices/fusion/tilt_gains.h"
#include "devices/head_geometry.h"
#include "devices/imu_sample.h"

namespace foverig {

enum class Predictor { none, constant_rate, constant_acceleration };

struct HeadFusionConfig {
    double initial_yaw_rad = 0;           ///< about y, of the first sample
    double tilt_gain_per_s = 0.25;        ///< LibOVR's; larger while the offset is not known
    double offset_sigma_rad_s = 3.5e-3;   ///< of the gyro at the start, as TiltGainsConfig's
    double max_gravity_error_m_s2 = 0.8;  ///< OpenHMD's: the head is accelerating beyond it
    double max_still_rate_rad_s = 0.1;    ///< OpenHMD's and Monado's: the head turns beyond it
    /// Own choice: at it a lever of 0.1 m pulls by 0.1 m/s2, 0.6 degrees of gravity; a faster turn
    /// teaches no offset.
    double max_teaching_rate_rad_s = 1.0;
    double accel_time_constant_s = 0.1;  ///< low-pass of gravity, in the world's frame
    bool auto_bias = true;
    GyroBiasConfig bias{};
    Predictor predictor = Predictor::constant_acceleration;
    Nanoseconds max_prediction{100'000'000};  ///< later times get the pose of this limit, stale
    Nanoseconds max_gap{250'000'000};         ///< a longer gap is not integrated: stale
    dvec3 eyes_from_neck_m = kEyesFromNeck_m;
    dvec3 sensor_from_eyes_m = kImuFromEyes_m;  ///< its acceleration is taken off gravity
};

class HeadFusion {
  public:
    explicit HeadFusion(const HeadFusionConfig& config = {});

    /// In order; a sample that is not later than the last in device time is ignored.
    void add(const ImuSample& sample);

    /// Predicted, or a little in the past; stale before the first sample.
    Pose at(HostTime time) const;

    bool started() const { return started_; }
    HostTime newest_sample() const { return newest_.host_time; }
    const GyroBias& bias() const { return bias_; }

  private:
    void start(const ImuSample& sample);
    void integrate(const ImuSample& sample, double dt_s);
    void sense_gravity(const dvec3& accel_m_s2, double dt_s);
    void correct_tilt(const dvec3& accel_m_s2, double dt_s);
    dvec3 offset_rad_s(double temperature_c) const {
        return bias_.offset_rad_s(temperature_c) + offset_by_gravity_rad_s_;
    }
    bool near_gravity(const dvec3& force_m_s2) const;
    void remember_rate(const ImuSample& sample);
    dvec3 angular_acceleration_rad_s2() const;

    struct Rate {
        Dk2Time time;
        dvec3 rad_s;
    };
    /// World: what the sensor felt, and its velocity by the head's turning alone.
    struct Felt {
        dvec3 force_m_s2, velocity_m_s;
    };

    HeadFusionConfig config_;
    GyroBias bias_;
    TiltGains gains_;
    bool started_ = false;
    bool lost_track_ = false;  ///< a gap too long to integrate was passed
    ImuSample newest_;
    dvec3 rate_rad_s_{0};               ///< of the newest sample, bias removed
    dvec3 offset_by_gravity_rad_s_{0};  ///< beyond what the last still moment told
    dquat world_from_head_{1, 0, 0, 0};
    dvec3 gravity_world_m_s2_{0};  ///< low-passed specific force of a sensor on no lever
    double gravity_s_ = 0;         ///< how long gravity has been sensed
    std::optional<Felt> felt_;     ///< at the newest sample
    std::deque<Rate> recent_;
};

}  // namespace foverig
