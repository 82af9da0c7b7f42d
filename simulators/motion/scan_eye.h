#pragma once
// Looking about a scene: fixations of ex-Gaussian length, saccades between them, micro-saccades
// and drift within them (DEVICES.md 5.1, 5.2). Gaze stays within 20 degrees of straight ahead, as
// larger shifts are the head's (5.3).
#include <cstdint>
#include <vector>

#include "simulators/motion/band_noise.h"
#include "simulators/motion/eye_motion.h"
#include "simulators/motion/gaze_path.h"

namespace foverig::motion {

class ScanEye final : public EyeMotion {
  public:
    static constexpr double kCycle_s = 600.0;
    static constexpr double kReach_deg = 20.0;

    struct Settings {
        double fixation_mu_s = 0.180, fixation_sigma_s = 0.050, fixation_tau_s = 0.110;
        double fixation_floor_s = 0.080;
        double target_sigma_deg = 8.0;  ///< of targets about straight ahead; own choice
        double micro_rate_hz = 1.2;     ///< micro-saccades during fixations
        double micro_median_deg = 0.35;
        double micro_sigma_ln = 0.4;    ///< own choice; clamped to 0.1 to 1 degree
        double drift_arcmin2_s = 30.0;  ///< diffusion per axis: variance 2 D t
        double vergence_m = 1.5;
    };
    struct Fixation {
        double start_s, end_s;
        dvec2 target_deg;
    };

    explicit ScanEye(std::uint64_t seed) : ScanEye(seed, Settings{}) {}
    ScanEye(std::uint64_t seed, const Settings& settings);

    EyeState at(double t_s) const override;
    const std::vector<Fixation>& fixations() const { return fixations_; }
    const GazePath& path() const { return path_; }

  private:
    double fixate(const Draws& draws, std::uint64_t index, double start_s, const dvec2& target_deg);

    Settings settings_;
    GazePath path_{kCycle_s};
    std::vector<Fixation> fixations_;
    BandNoise drift_x_, drift_y_;
};

}  // namespace foverig::motion
