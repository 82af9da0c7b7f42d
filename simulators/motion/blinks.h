#pragma once
// Blinks (DEVICES.md 5.4): a Poisson train with 0.5 s dead time; 40 % of a blink the lid goes down,
// 20 % it is closed, 40 % it goes up; 180 ms in all, log-normal.
#include <cstdint>
#include <vector>

#include "simulators/motion/eye_motion.h"

namespace foverig::motion {

class Blinks {
  public:
    static constexpr double kCycle_s = 600.0;

    struct Blink {
        double start_s, duration_s;
    };

    /// `per_minute` at most 100; 0: none.
    Blinks(std::uint64_t seed, double per_minute);

    /// 1 outside blinks.
    double openness(double t_s) const;
    const std::vector<Blink>& blinks() const { return blinks_; }

  private:
    std::vector<Blink> blinks_;
};

/// An eye that moves as another does, and blinks.
class BlinkingEye final : public EyeMotion {
  public:
    /// `eye` outlives this one.
    BlinkingEye(const EyeMotion& eye, std::uint64_t seed, double per_minute)
        : eye_(eye), blinks_(seed, per_minute) {}
    EyeState at(double t_s) const override;

  private:
    const EyeMotion& eye_;
    Blinks blinks_;
};

}  // namespace foverig::motion
