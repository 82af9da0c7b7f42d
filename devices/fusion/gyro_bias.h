#pragma once
// The gyro's offset, learnt while the headset lies still (DEVICES.md 3.1, autocalibrate.c). Gravity
// must lie still too, so that a slow nod or tilt is not learnt. A steady turn about the vertical of
// less than max_deviation_rad_s looks like an offset to both sensors and is taken for one.
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
};

class GyroBias {
  public:
    explicit GyroBias(const GyroBiasConfig& config = {}) : config_(config) {}

    /// `gyro_rad_s` with no offset taken off; `dt_s` since the sample before.
    void add(const dvec3& gyro_rad_s, const dvec3& accel_m_s2, double dt_s);

    const dvec3& offset_rad_s() const { return offset_rad_s_; }
    bool known() const { return known_; }

  private:
    void restart();
    void adopt_if_gravity_was_still();

    GyroBiasConfig config_;
    dvec3 smooth_{0}, mean_{0}, offset_rad_s_{0};
    dvec3 accel_mean_m_s2_{0}, accel_squares_{0};  ///< squared deviations, summed (Welford)
    int samples_ = 0;
    double still_s_ = 0;
    bool known_ = false;
};

}  // namespace foverig
