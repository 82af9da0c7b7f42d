#pragma once
// Eyes that look at what they are shown: the person in front of a calibration's targets.
#include <cstdint>
#include <vector>

#include "simulators/motion/band_noise.h"
#include "simulators/motion/eye_motion.h"
#include "simulators/motion/gaze_path.h"

namespace foverig::motion {

/// After DEVICES.md 5.1 a target is noticed after 190 ms or so (100 to 300), the saccade to it
/// falls 7 % short, and a second one follows 150 ms later; in between the eyes drift (5.2). No
/// micro-saccades. Straight ahead before the first target. One thread shows and asks.
class GuidedEye final : public EyeMotion {
  public:
    static constexpr double kVergence_m = 1.5;

    explicit GuidedEye(std::uint64_t seed);

    /// `t_s` does not go back. What the eyes would have done for an older target after they notice
    /// this one they do not.
    void show(double t_s, const dvec2& target_deg);
    EyeState at(double t_s) const override;

  private:
    const GazeLeg* leg_at(double t_s) const;
    void jump(double t_s, const dvec2& to_deg);

    Draws draws_;
    BandNoise drift_x_, drift_y_;
    std::uint64_t shown_ = 0;
    std::vector<GazeLeg> legs_;
};

}  // namespace foverig::motion
