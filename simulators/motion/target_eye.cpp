#include "simulators/motion/target_eye.h"

#include <algorithm>
#include <limits>

#include "simulators/motion/random.h"

namespace foverig::motion {
namespace {

constexpr double kCycle_s = 60.0;
constexpr double kLatency_s = 0.125;
constexpr double kCatchUp_deg = 1.0;

/// The default line of DEVICES.md 5.3 through its two points.
double pursuit_gain(double speed_deg_s) {
    return std::clamp(0.95 - (speed_deg_s - 15.0) * (0.15 / 25.0), 0.5, 1.0);
}

}  // namespace

GazePath target_path(std::uint64_t seed, const TargetSettings& settings) {
    const Draws draws(seed, 300);
    GazePath path(kCycle_s);
    dvec2 at_deg(0.0);
    double now_s = 0.0;
    for (std::uint64_t i = 0; now_s < kCycle_s; i += 2) {
        dvec2 corner_deg(draws.uniform(i, -settings.reach_deg, settings.reach_deg),
                         draws.uniform(i + 1, -settings.reach_deg, settings.reach_deg));
        double length_s = glm::distance(at_deg, corner_deg) / settings.speed_deg_s;
        // The last leg leads home and takes what time is left, slower than the others.
        const double back_s = glm::length(corner_deg) / settings.speed_deg_s;
        if (now_s + length_s + back_s > kCycle_s) {
            corner_deg = dvec2(0.0);
            length_s = kCycle_s - now_s;
        }
        path.add(now_s, dvec2(0.0), (corner_deg - at_deg) / length_s);
        now_s += length_s;
        at_deg = corner_deg;
    }
    return path;
}

PursuitEye::PursuitEye(std::uint64_t seed, const TargetSettings& settings)
    : target_(target_path(seed, settings)), path_(kCycle_s) {
    path_.add(0.0, dvec2(0.0), dvec2(0.0));
    const auto& legs = target_.legs();
    for (std::size_t i = 0; i < legs.size(); ++i) {
        const double end_s = i + 1 < legs.size() ? legs[i + 1].start_s + kLatency_s : kCycle_s;
        const double speed = glm::length(legs[i].glide_deg_s);
        const double slip_deg_s = (1.0 - pursuit_gain(speed)) * speed;
        const double period_s =
            slip_deg_s > 0.0 ? kCatchUp_deg / slip_deg_s : std::numeric_limits<double>::infinity();
        for (double t_s = legs[i].start_s + kLatency_s; t_s + 0.1 < end_s; t_s += period_s) {
            catch_up(t_s, legs[i]);
        }
    }
    const double home_s = kCycle_s - 0.08;
    path_.add(home_s, -path_.end_deg(home_s), dvec2(0.0));
}

/// A saccade that lands on the target, then a glide at the eye's own speed.
void PursuitEye::catch_up(double t_s, const GazeLeg& leg) {
    const dvec2 glide_deg_s = pursuit_gain(glm::length(leg.glide_deg_s)) * leg.glide_deg_s;
    const dvec2 from_deg = path_.end_deg(t_s);
    double landing_s = t_s;
    dvec2 jump_deg(0.0);
    // The saccade's length and duration depend on each other; two rounds settle it.
    for (int round = 0; round < 3; ++round) {
        jump_deg = leg.at(landing_s) - from_deg - (landing_s - t_s) * glide_deg_s;
        landing_s = t_s + saccade_duration_s(glm::length(jump_deg));
    }
    path_.add(t_s, jump_deg, glide_deg_s);
}

EyeState PursuitEye::at(double t_s) const {
    return {.direction = direction_of(path_.gaze_deg(t_s)), .saccade = path_.jumping(t_s)};
}

}  // namespace foverig::motion
