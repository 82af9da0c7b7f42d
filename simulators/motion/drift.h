#pragma once
#include <cmath>

#include "simulators/motion/band_noise.h"

namespace foverig::motion {

/// The eye's drift in a fixation along one axis, degrees (DEVICES.md 5.2): a random walk of
/// diffusion D has a rate of flat one-sided density 4 D.
inline BandNoise fixation_drift(std::uint64_t seed, std::uint64_t stream, double arcmin2_s) {
    constexpr double kLow_hz = 0.3, kHigh_hz = 40.0;
    constexpr int kSines = 32;
    const double rms_deg_s = std::sqrt(4.0 * arcmin2_s * (kHigh_hz - kLow_hz)) / 60.0;
    return BandNoise(Draws(seed, stream), kLow_hz, kHigh_hz, rms_deg_s, kSines);
}

}  // namespace foverig::motion
