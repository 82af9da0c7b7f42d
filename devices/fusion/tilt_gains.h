#pragma once
// How much of the tilt that gravity shows to be wrong is taken back at once, and how much of it is
// put down to the gyro's offset: the gains of a Kalman filter of those two, about one horizontal
// axis. At first little is known and they are high; they fall with what has become known, and end
// at `end_gain_per_s` and, critically damped, a quarter of its square (Mahony et al. 2008). A body
// that sways shows by how unsteady the error is, and gravity is trusted the less.
#include <optional>

#include "devices/math.h"

namespace foverig {

struct TiltGainsConfig {
    double end_gain_per_s = 0.25;        ///< LibOVR's (DEVICES.md 3.1); 0: none at the end
    double offset_sigma_rad_s = 3.5e-3;  ///< 0.2 deg/s: what the factory leaves (6.2)
    double walk_rad_s_sqrt_s = 5e-5;     ///< of the offset (6.2); above 0
    double response_s = 0.1;  ///< gravity is told no faster: no gain is above its inverse
    bool learns_offset = true;
};

/// Covariances are in units of the noise density of gravity's direction. Walk and end gain imply
/// it, as (walk / (end gain^2 / 4))^2: 3.2e-3 rad sqrt(s), ten times an accelerometer's own, as the
/// forces on a moving head are not gravity's alone.
class TiltGains {
  public:
    /// Of the error: of the tilt, and of the offset by s.
    struct Shares {
        double tilt = 0;
        double offset_per_s = 0;
    };

    explicit TiltGains(const TiltGainsConfig& config = {});

    /// Where up is is not known any more; of the offset, what was known still is.
    void forget_tilt();
    /// Another has told the offset, as well as gravity ever will: the gains are the end's.
    void offset_told();

    void pass(double dt_s);
    /// Tilt is the mean of what gravity showed in all the time since it was forgotten.
    Shares believe();
    /// A part of `error_rad` is taken back. Where gravity does not teach (`teaches`), the offset is
    /// left alone and tilt is pulled no more than by a plain mean or the end's gain.
    Shares pull(const dvec3& error_rad, double dt_s, bool teaches);

  private:
    double noise_of(const dvec3& error_rad, double dt_s);
    void correct(const Shares& shares, double noise);

    TiltGainsConfig config_;
    double offset_scale_;  ///< from rad/s to the units kept
    double tilt_walk_ = 0, offset_walk_ = 0;
    double tilt_tilt_ = 0, tilt_offset_ = 0, offset_offset_ = 0;  ///< covariances
    double since_s_ = 0;                                          ///< tilt was forgotten
    std::optional<dvec3> mean_error_rad_;                         ///< of the last second
    double sway_rad2_ = 0;                                        ///< its variance
};

}  // namespace foverig
