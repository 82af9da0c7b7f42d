#pragma once
// The moving target of Weier et al. 2016 (4.2: a sphere that moves linearly along paths across the
// image plane), an eye that is always on it, and one that pursues it as eyes do.
#include <cstdint>

#include "simulators/motion/eye_motion.h"
#include "simulators/motion/gaze_path.h"

namespace foverig::motion {

struct TargetSettings {
    double speed_deg_s = 10.0;  ///< own choice; the paper gives none
    double reach_deg = 10.0;    ///< half side of the square its corners lie in; the paper kept
                                ///< to about 10.3 by 11.7 degrees when judging gaze
};

/// Straight legs between random corners, at constant speed; repeats after 60 s.
GazePath target_path(std::uint64_t seed, const TargetSettings& settings);

class TargetEye final : public EyeMotion {
  public:
    explicit TargetEye(std::uint64_t seed, const TargetSettings& settings = {})
        : path_(target_path(seed, settings)) {}
    EyeState at(double t_s) const override {
        return {.direction = direction_of(path_.gaze_deg(t_s))};
    }

  private:
    GazePath path_;
};

/// Pursuit (DEVICES.md 5.3): notices a turn of the target after 125 ms, then jumps onto it and
/// follows with a gain of 0.95 at 15 deg/s and 0.8 at 40 deg/s; catches up when 1 degree behind.
class PursuitEye final : public EyeMotion {
  public:
    explicit PursuitEye(std::uint64_t seed, const TargetSettings& settings = {});
    EyeState at(double t_s) const override;

    const GazePath& target() const { return target_; }
    const GazePath& path() const { return path_; }

  private:
    void catch_up(double t_s, const GazeLeg& leg);

    GazePath target_;
    GazePath path_;
};

}  // namespace foverig::motion
