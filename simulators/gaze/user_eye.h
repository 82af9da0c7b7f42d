#pragma once
// What sets one person's eyes apart from the eye that an uncalibrated tracker assumes. Such a
// tracker sees the optical axis, not the line of sight, and takes the pupil's shift in its camera
// for the angle.
#include <cstdint>

#include "devices/math.h"
#include "simulators/gaze/tracker_geometry.h"

namespace foverig {

/// Angle kappa: the line of sight lies nasal of the optical axis by about 5 degrees and above it by
/// about 1.5 (Guestrin and Eizenman 2006, IEEE TBME 53; recalled, not re-read; DEVICES.md gives no
/// figure). Spreads, gain and roll are our own choice.
class UserEye {
  public:
    static constexpr double kKappaNasal_deg = 5.0, kKappaUp_deg = 1.5, kKappaSigma_deg = 1.0;
    static constexpr double kGainSigma = 0.04;  ///< per axis: the cornea, and the camera's slant
    static constexpr double kRollSigma_deg = 2.0;

    /// The person is `seed`'s; `strength` times as different as people are.
    UserEye(Side side, std::uint64_t seed, double strength);

    /// Gaze angles (motion::direction_of) as an uncalibrated tracker has them.
    dvec2 seen_deg(const dvec2& gaze_deg) const;

  private:
    double strength_;
    dvec2 optical_from_gaze_deg_;
    glm::dmat2 image_from_shift_;
};

}  // namespace foverig
