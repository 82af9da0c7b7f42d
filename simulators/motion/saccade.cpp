#include "simulators/motion/saccade.h"

#include <cmath>

namespace foverig::motion {

double saccade_peak_deg_s(double amplitude_deg) {
    return -520.0 * std::expm1(-amplitude_deg / 8.5);
}

double saccade_duration_s(double amplitude_deg) {
    return 2.4e-3 * amplitude_deg + 22e-3;
}

// The mean of 1 - |x|^m over a lobe is m / (m + 1), so V D / A = (m + 1) / m fixes m. The ratio is
// above 1.3 for every amplitude up to 90 degrees.
SaccadeProfile::SaccadeProfile(double amplitude_deg)
    : duration_s_(saccade_duration_s(amplitude_deg)),
      peak_share_(0.45 - 0.0015 * amplitude_deg),
      exponent_(amplitude_deg > 0.0
                    ? 1.0 / (saccade_peak_deg_s(amplitude_deg) * duration_s_ / amplitude_deg - 1.0)
                    : 1.0) {}

double SaccadeProfile::progress(double since_start_s) const {
    if (since_start_s <= 0.0) return 0.0;
    if (since_start_s >= duration_s_) return 1.0;
    const double from_peak = since_start_s / duration_s_ - peak_share_;
    const double lobe = from_peak < 0.0 ? peak_share_ : 1.0 - peak_share_;
    const double x = std::abs(from_peak) / lobe;
    // Area of the lobe between the peak and x, as a share of a whole lobe's.
    const double area = x * (exponent_ + 1.0 - std::pow(x, exponent_)) / exponent_;
    return peak_share_ + std::copysign(lobe * area, from_peak);
}

double SaccadeProfile::rate_per_s(double since_start_s) const {
    if (since_start_s <= 0.0 || since_start_s >= duration_s_) return 0.0;
    const double from_peak = since_start_s / duration_s_ - peak_share_;
    const double x = std::abs(from_peak) / (from_peak < 0.0 ? peak_share_ : 1.0 - peak_share_);
    return (1.0 - std::pow(x, exponent_)) * (exponent_ + 1.0) / exponent_ / duration_s_;
}

}  // namespace foverig::motion
