#pragma once
// The gyro's offset, learnt while the headset lies still (DEVICES.md 3.1, autocalibrate.c). Gravity
// must lie still too, so that a slow nod or tilt is not learnt. A steady turn about the vertical of
// less than max_deviation_rad_s looks like an offset to both sensors and is taken for one.
//
// The offset also moves with the chip's temperature. Each still moment after another is one
// equation, offset gained = slope * warmth gained + what walked meanwhile, and the slope is their
// least-squares solution that begins at 0 +- slope_sigma (a Gaussian prior).
#include "devices/imu_sample.h"

namespace foverig {

struct GyroBiasConfig {
    double smoothing = 0.4;             ///< weight of a new sample
    double max_rate_rad_s = 0.349066;   ///< 20 deg/s: certainly moving
    double max_deviation_rad_s = 0.03;  ///< from the running mean
    double full_s = 6;                  ///< still as long: the mean is the offset
    double partial_s = 3;               ///< ended by motion after this long: the mean is used too
    /// Own choice: standard deviation of the accelerometer per axis, twice its noise (6.2). A turn
    /// of 0.6 deg/s across gravity passes it in 6 s.
    double max_accel_deviation_m_s2 = 0.2;
    /// Per axis, before anything is learnt: a third of the 0.24 deg/s/C that a chip may have (6.2).
    /// 0: nothing is learnt.
    double slope_sigma_rad_s_c = 1.4e-3;
    double mean_sigma_rad_s = 4e-5;   ///< of a still moment: 3.1e-3 of 6000 samples (6.2)
    double walk_rad_s_sqrt_s = 5e-5;  ///< of the offset, between two (6.2)
};

class GyroBias {
  public:
    explicit GyroBias(const GyroBiasConfig& config = {}) : config_(config) {}

    /// `gyro_rad_s` with no offset taken off; `dt_s` since the sample before. True where a still
    /// moment has just told the offset.
    bool add(const dvec3& gyro_rad_s, const dvec3& accel_m_s2, double temperature_c, double dt_s);

    dvec3 offset_rad_s(double temperature_c) const {
        return learnt_.rad_s + (temperature_c - learnt_.temperature_c) * slope_rad_s_c();
    }
    dvec3 slope_rad_s_c() const;
    bool known() const { return known_; }

  private:
    void restart();
    bool adopt_if_gravity_was_still();

    /// One still moment's.
    struct Moment {
        dvec3 rad_s{0};
        double temperature_c = 0;
        double time_s = 0;
    };
    void learn_slope(const Moment& later);

    GyroBiasConfig config_;
    Moment learnt_;
    dvec3 slope_sum_{0};  ///< of the equations, each by its weight
    double slope_information_ = 0;
    double time_s_ = 0;
    dvec3 smooth_{0}, mean_{0};
    double mean_temperature_c_ = 0;
    dvec3 accel_mean_m_s2_{0}, accel_squares_{0};  ///< squared deviations, summed (Welford)
    int samples_ = 0;
    double still_s_ = 0;
    bool known_ = false;
};

}  // namespace foverig
