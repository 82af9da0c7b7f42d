#include "simulators/motion/scan_eye.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulators/motion/drift.h"

namespace foverig::motion {
namespace {

constexpr double kSmallestSaccade_deg = 1.0;  // anything smaller is a micro-saccade

dvec2 next_target(const Draws& draws, std::uint64_t index, const dvec2& from_deg, double sigma) {
    for (std::uint64_t attempt = 0;; ++attempt) {
        const std::uint64_t i = index + (attempt << 32);
        const dvec2 target(sigma * draws.normal(i), sigma * draws.normal(i + 1));
        if (glm::length(target) < ScanEye::kReach_deg &&
            glm::distance(target, from_deg) > kSmallestSaccade_deg) {
            return target;
        }
    }
}

}  // namespace

ScanEye::ScanEye(std::uint64_t seed, const Settings& settings)
    : settings_(settings),
      drift_x_(fixation_drift(seed, 201, settings.drift_arcmin2_s)),
      drift_y_(fixation_drift(seed, 202, settings.drift_arcmin2_s)) {
    const Draws draws(seed, 200);
    const double last_start_s = kCycle_s - 1.0;
    dvec2 target_deg(0.0);
    path_.add(0.0, dvec2(0.0), dvec2(0.0));
    double now_s = 0.0;
    for (std::uint64_t index = 0; now_s < last_start_s; index += 64) {
        now_s = std::min(fixate(draws, index, now_s, target_deg), last_start_s);
        const bool home = now_s >= last_start_s;
        target_deg =
            home ? dvec2(0.0)
                 : next_target(draws, index + 60, path_.end_deg(now_s), settings.target_sigma_deg);
        path_.add(now_s, target_deg - path_.end_deg(now_s), dvec2(0.0));
        now_s += path_.legs().back().saccade.duration_s();
    }
}

/// Adds the micro-saccades of one fixation and gives its end.
double ScanEye::fixate(const Draws& draws, std::uint64_t index, double start_s,
                       const dvec2& target_deg) {
    const double length_s =
        std::max(settings_.fixation_floor_s,
                 settings_.fixation_mu_s + settings_.fixation_sigma_s * draws.normal(index) +
                     draws.exponential(index + 1, settings_.fixation_tau_s));
    const double end_s = std::min(start_s + length_s, kCycle_s - 1.0);
    fixations_.push_back({start_s, end_s, target_deg});
    if (settings_.micro_rate_hz <= 0.0) return end_s;
    double at_s = start_s;
    for (std::uint64_t i = index + 2; i < index + 56; i += 3) {
        at_s += draws.exponential(i, 1.0 / settings_.micro_rate_hz);
        const double amplitude_deg = std::clamp(
            draws.log_normal(i + 1, settings_.micro_median_deg, settings_.micro_sigma_ln), 0.1,
            1.0);
        if (at_s + saccade_duration_s(amplitude_deg) > end_s) break;
        const double heading = 2.0 * std::numbers::pi * draws.uniform(i + 2);
        const dvec2 offset_deg = path_.end_deg(at_s) - target_deg;
        // Those that find the eye off its target lead back to it, the others away from it.
        const dvec2 towards = glm::length(offset_deg) > 0.1
                                  ? -glm::normalize(offset_deg)
                                  : dvec2(std::cos(heading), std::sin(heading));
        path_.add(at_s, amplitude_deg * towards, dvec2(0.0));
        at_s += path_.legs().back().saccade.duration_s();
    }
    return end_s;
}

EyeState ScanEye::at(double t_s) const {
    const dvec2 drift_deg(drift_x_.at(t_s).value, drift_y_.at(t_s).value);
    return {.direction = direction_of(path_.gaze_deg(t_s) + drift_deg),
            .saccade = path_.jumping(t_s),
            .vergence_m = settings_.vergence_m};
}

}  // namespace foverig::motion
