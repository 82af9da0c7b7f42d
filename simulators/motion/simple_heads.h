#pragma once
// Head motions that are one formula: still, shaking, and a single step.
#include "simulators/motion/head_motion.h"

namespace foverig::motion {

class StillHead final : public HeadMotion {
  public:
    HeadState at(double) const override { return head_from_angles({}, {}, {}); }
};

/// Yaw swings as a sine (DEVICES.md 6.1), which grows out of rest as a real head's does. With a
/// knock, the head's shell jolts sideways once.
class ShakeHead final : public HeadMotion {
  public:
    struct Settings {
        double frequency_hz = 5.0;
        double amplitude_deg = 5.5;
        double rest_s = 0.5;        ///< before the swing starts; own choice
        double growth_s = 1.0;      ///< until it has its amplitude; own choice
        double knock_peak_g = 0.0;  ///< 0: none
        double knock_duration_s = 0.005;
        double knock_time_s = 5.0;  ///< its middle
    };
    explicit ShakeHead(const Settings& settings) : settings_(settings) {}
    HeadState at(double t_s) const override;

    static Settings stress() { return {}; }
    static Settings extreme() { return {.amplitude_deg = 11.0, .knock_peak_g = 6.0}; }

  private:
    Settings settings_;
};

/// One minimum-jerk turn to the left, for latency by phase.
class StepHead final : public HeadMotion {
  public:
    struct Settings {
        double start_s = 1.0;
        double amplitude_deg = 10.0;
        double duration_s = 0.1;
    };
    StepHead() = default;
    explicit StepHead(const Settings& settings) : settings_(settings) {}
    HeadState at(double t_s) const override;

  private:
    Settings settings_;
};

}  // namespace foverig::motion
