#pragma once
// Casual looking round (DEVICES.md 6.1): head shifts that follow the minimum-jerk law between
// pauses, with band-limited noise on top. Repeats its shifts after kCycle_s.
#include <array>
#include <cstdint>
#include <vector>

#include "simulators/motion/band_noise.h"
#include "simulators/motion/head_motion.h"

namespace foverig::motion {

/// Duration of a minimum-jerk head shift: its peak speed is 4.5 A^0.9 deg/s, at most 350 deg/s.
double head_shift_duration_s(double amplitude_deg);

class LookHead final : public HeadMotion {
  public:
    static constexpr double kCycle_s = 600.0;

    struct Settings {
        double amplitude_median_deg = 25.0;
        double amplitude_sigma_ln = 0.5;  ///< spread of the log-normal; own choice
        double amplitude_max_deg = 110.0;
        double yaw_limit_deg = 75.0;  ///< shifts that would pass it turn back; own choice
        double pause_min_s = 0.3;     ///< between shifts; own choice
        double pause_mean_s = 0.9;
        double noise_rms_deg_s = 2.0;  ///< 0.2 to 3 Hz
        double pitch_share = 0.40;     ///< of the yaw's amplitude and noise
        double roll_share = 0.15;
    };
    struct Shift {
        double start_s, duration_s;
        std::array<double, 3> from_deg;  ///< yaw, pitch, roll
        std::array<double, 3> amplitude_deg;
    };

    explicit LookHead(std::uint64_t seed) : LookHead(seed, Settings{}) {}
    LookHead(std::uint64_t seed, const Settings& settings);

    HeadState at(double t_s) const override;
    const std::vector<Shift>& shifts() const { return shifts_; }

  private:
    Jet angle_deg(int axis, double t_s, const Shift& shift) const;

    std::vector<Shift> shifts_;
    std::array<BandNoise, 3> noise_;
};

}  // namespace foverig::motion
