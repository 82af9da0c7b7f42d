#include "simulators/motion/blinks.h"

#include <algorithm>
#include <cmath>

#include "simulators/motion/random.h"

namespace foverig::motion {
namespace {

constexpr double kDeadTime_s = 0.5;
constexpr double kMedian_s = 0.180, kSigmaLn = 0.35;
constexpr double kShortest_s = 0.080, kLongest_s = 0.500;

}  // namespace

Blinks::Blinks(std::uint64_t seed, double per_minute) {
    if (per_minute <= 0.0) return;
    const Draws draws(seed, 400);
    const double mean_wait_s = std::max(0.0, 60.0 / per_minute - kDeadTime_s);
    double now_s = 0.0;
    for (std::uint64_t i = 0;; i += 2) {
        // From start to start, so that the rate is the one asked for.
        now_s += kDeadTime_s + draws.exponential(i, mean_wait_s);
        if (now_s > kCycle_s - kLongest_s) break;
        blinks_.push_back({now_s, std::clamp(draws.log_normal(i + 1, kMedian_s, kSigmaLn),
                                             kShortest_s, kLongest_s)});
    }
}

double Blinks::openness(double t_s) const {
    const double phase_s = t_s - std::floor(t_s / kCycle_s) * kCycle_s;
    const auto next =
        std::upper_bound(blinks_.begin(), blinks_.end(), phase_s,
                         [](double t, const Blink& blink) { return t < blink.start_s; });
    if (next == blinks_.begin()) return 1.0;
    const Blink& blink = *(next - 1);
    const double u = (phase_s - blink.start_s) / blink.duration_s;
    return std::clamp(std::max(1.0 - u / 0.4, (u - 0.6) / 0.4), 0.0, 1.0);
}

EyeState BlinkingEye::at(double t_s) const {
    EyeState state = eye_.at(t_s);
    state.openness = std::min(state.openness, blinks_.openness(t_s));
    state.blink = state.openness < 1.0;
    return state;
}

}  // namespace foverig::motion
