#pragma once
// From a stand, a head pose and a gaze to what an eye sees.
#include "devices/display/dk2_optics.h"
#include "devices/fusion/pose.h"
#include "renderer/camera.h"
#include "rig/scenario/scenario.h"
#include "rig/session/camera_flight.h"

namespace foverig {

class EyeViews {
  public:
    static constexpr double kHalfIpd_m = 0.032;  ///< DEVICES.md 2.1

    explicit EyeViews(const DisplaySettings& display) : display_(display) {}

    /// `gaze` is a unit direction in the head's frame, whose axes are the eye's.
    EyeInput eye(Eye eye, const Stand& stand, const Pose& pose, const dvec3& gaze) const;

  private:
    DisplaySettings display_;
    Dk2Optics optics_;
};

}  // namespace foverig
