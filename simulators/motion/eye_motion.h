#pragma once
// Ground truth of the eyes in the head: a pure function of time.
#include "devices/math.h"

namespace foverig::motion {

struct EyeState {
    dvec3 direction{0.0, 0.0, -1.0};  ///< unit, head frame; from the point between the eyes
    double openness = 1.0;            ///< 0 closed, 1 open
    bool blink = false;               ///< from the lid's first move down to its last one up
    bool saccade = false;
    double vergence_m = 1.5;  ///< distance at which the two eyes' rays meet
};

class EyeMotion {
  public:
    virtual ~EyeMotion() = default;
    virtual EyeState at(double t_s) const = 0;
};

/// Gaze angles in degrees, x to the right and y upwards, as a direction and back.
dvec3 direction_of(const dvec2& gaze_deg);
dvec2 gaze_of(const dvec3& direction);

class StillEye final : public EyeMotion {
  public:
    explicit StillEye(const dvec2& gaze_deg = dvec2(0.0)) : direction_(direction_of(gaze_deg)) {}
    EyeState at(double) const override { return {.direction = direction_}; }

  private:
    dvec3 direction_;
};

}  // namespace foverig::motion
