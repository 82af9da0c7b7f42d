#include "metrics/temporal_filters.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace foverig::metrics {

TemporalFilters::TemporalFilters(double frames_per_s) {
    constexpr double kReach_s = 0.25, kPeak_s = 0.06, kWidth = 0.5, kOffset_s = 1.0e-4;
    constexpr double kTransientGain = 0.062170507756932;
    if (!(frames_per_s >= 8.0))
        throw std::invalid_argument(
            fmt::format("{:g} frames a second are too few to judge flicker by; expected 8 or more",
                        frames_per_s));
    const auto taps = static_cast<std::size_t>(std::ceil(kReach_s * frames_per_s));
    const double step_s =
        static_cast<double>(taps) / (frames_per_s * static_cast<double>(taps - 1));
    double sum = 0.0;
    for (std::size_t i = 0; i < taps; ++i) {
        const double late =
            std::log(static_cast<double>(i) * step_s + kOffset_s) - std::log(kPeak_s);
        sustained.push_back(std::exp(-late * late / (2.0 * kWidth * kWidth)));
        sum += sustained.back();
    }
    for (double& tap : sustained) tap /= sum;
    transient.resize(taps);
    for (std::size_t i = 0; i + 1 < taps; ++i)
        transient[i] = kTransientGain * (sustained[i + 1] - sustained[i]) / step_s;
}

}  // namespace foverig::metrics
