#include "simulators/motion/guided_eye.h"

#include <algorithm>

#include "simulators/motion/drift.h"

namespace foverig::motion {
namespace {

constexpr double kLatency_s = 0.190, kLatencySigma_s = 0.030;
constexpr double kShortest_s = 0.100, kLongest_s = 0.300;
constexpr double kFirstShare = 0.93;
constexpr double kCorrection_s = 0.150;    // from the first saccade's end
constexpr double kDrift_arcmin2_s = 30.0;  // as ScanEye's
constexpr double kLeast_deg = 0.1;         // nobody corrects less

}  // namespace

GuidedEye::GuidedEye(std::uint64_t seed)
    : draws_(seed, 210),
      drift_x_(fixation_drift(seed, 211, kDrift_arcmin2_s)),
      drift_y_(fixation_drift(seed, 212, kDrift_arcmin2_s)) {}

const GazeLeg* GuidedEye::leg_at(double t_s) const {
    const auto next =
        std::upper_bound(legs_.begin(), legs_.end(), t_s,
                         [](double t, const GazeLeg& leg) { return t < leg.start_s; });
    return next == legs_.begin() ? nullptr : &*(next - 1);
}

void GuidedEye::jump(double t_s, const dvec2& to_deg) {
    const dvec2 from_deg = legs_.empty() ? dvec2(0.0) : legs_.back().at(t_s);
    const dvec2 way_deg = to_deg - from_deg;
    const double length_deg = glm::length(way_deg);
    if (length_deg < kLeast_deg) return;
    legs_.push_back({.start_s = t_s,
                     .from_deg = from_deg,
                     .jump_deg = way_deg,
                     .glide_deg_s = dvec2(0.0),
                     .saccade = SaccadeProfile(length_deg)});
}

void GuidedEye::show(double t_s, const dvec2& target_deg) {
    const double latency_s =
        std::clamp(kLatency_s + kLatencySigma_s * draws_.normal(shown_++), kShortest_s, kLongest_s);
    const double start_s = t_s + latency_s;
    while (!legs_.empty() && legs_.back().start_s >= start_s) legs_.pop_back();
    const dvec2 from_deg = legs_.empty() ? dvec2(0.0) : legs_.back().at(start_s);
    jump(start_s, from_deg + kFirstShare * (target_deg - from_deg));
    if (legs_.empty()) return;
    jump(
        std::max(start_s, legs_.back().start_s + legs_.back().saccade.duration_s()) + kCorrection_s,
        target_deg);
}

EyeState GuidedEye::at(double t_s) const {
    const GazeLeg* leg = leg_at(t_s);
    const dvec2 drift_deg(drift_x_.at(t_s).value, drift_y_.at(t_s).value);
    return {.direction = direction_of((leg == nullptr ? dvec2(0.0) : leg->at(t_s)) + drift_deg),
            .saccade = leg != nullptr && leg->jumping(t_s),
            .vergence_m = kVergence_m};
}

}  // namespace foverig::motion
