#include "simulators/gaze/user_eye.h"

#include <cmath>

#include "simulators/motion/eye_motion.h"
#include "simulators/motion/random.h"

namespace foverig {
namespace {

constexpr std::uint64_t kStream = 830;

}  // namespace

UserEye::UserEye(Side side, std::uint64_t seed, double strength) : strength_(strength) {
    const motion::Draws draws(seed, kStream + static_cast<std::uint64_t>(side));
    const double temporal = side == Side::left ? -1.0 : 1.0;
    optical_from_gaze_deg_ = {temporal * (kKappaNasal_deg + kKappaSigma_deg * draws.normal(0)),
                              -(kKappaUp_deg + kKappaSigma_deg * draws.normal(1))};
    const dvec2 gain(1.0 + kGainSigma * draws.normal(2), 1.0 + kGainSigma * draws.normal(3));
    const double roll = glm::radians(kRollSigma_deg * draws.normal(4));
    const dvec2 right(std::cos(roll), std::sin(roll)), up(-std::sin(roll), std::cos(roll));
    image_from_shift_ = {gain * right, gain * up};
}

dvec2 UserEye::seen_deg(const dvec2& gaze_deg) const {
    const dvec3 optical = motion::direction_of(gaze_deg + optical_from_gaze_deg_);
    const dvec2 seen_deg = image_from_shift_ * glm::degrees(dvec2(optical.x, optical.y));
    return gaze_deg + strength_ * (seen_deg - gaze_deg);
}

}  // namespace foverig
