#include "simulators/motion/look_head.h"

#include <algorithm>
#include <cmath>

namespace foverig::motion {
namespace {

constexpr int kNoiseSines = 24;

BandNoise head_noise(std::uint64_t seed, int axis, double rms_deg_s) {
    return BandNoise(Draws(seed, 100 + axis), 0.2, 3.0, rms_deg_s, kNoiseSines);
}

/// A random direction, unless it leads out of the range that a neck is comfortable in.
double bounded_step(double from, double amplitude, double limit, double sign) {
    return std::abs(from + sign * amplitude) <= limit ? sign * amplitude
                                                      : -std::copysign(amplitude, from);
}

}  // namespace

double head_shift_duration_s(double amplitude_deg) {
    const double peak_deg_s = std::min(350.0, 4.5 * std::pow(amplitude_deg, 0.9));
    return kMinimumJerkPeak * amplitude_deg / peak_deg_s;
}

LookHead::LookHead(std::uint64_t seed, const Settings& settings)
    : noise_{head_noise(seed, 0, settings.noise_rms_deg_s),
             head_noise(seed, 1, settings.noise_rms_deg_s * settings.pitch_share),
             head_noise(seed, 2, settings.noise_rms_deg_s * settings.roll_share)} {
    const Draws draws(seed, 1);
    const std::array<double, 3> share{1.0, settings.pitch_share, settings.roll_share};
    std::array<double, 3> angle_deg{};
    double now_s = 0.0;
    const double last_start_s = kCycle_s - 5.0;
    for (std::uint64_t i = 0;; i += 8) {
        now_s += settings.pause_min_s +
                 draws.exponential(i, settings.pause_mean_s - settings.pause_min_s);
        const bool home = now_s >= last_start_s;
        double amplitude_deg =
            draws.log_normal(i + 1, settings.amplitude_median_deg, settings.amplitude_sigma_ln);
        amplitude_deg = std::clamp(amplitude_deg, 1.0, settings.amplitude_max_deg);
        Shift shift{std::min(now_s, last_start_s), 0.0, angle_deg, {}};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            shift.amplitude_deg[axis] =
                home ? -angle_deg[axis]
                     : bounded_step(angle_deg[axis], share[axis] * amplitude_deg,
                                    share[axis] * settings.yaw_limit_deg, draws.sign(i + 2 + axis));
            angle_deg[axis] += shift.amplitude_deg[axis];
        }
        // The last shift comes home, so that the cycle closes.
        shift.duration_s = home ? 2.0 : head_shift_duration_s(std::abs(shift.amplitude_deg[0]));
        now_s = shift.start_s + shift.duration_s;
        shifts_.push_back(shift);
        if (home) break;
    }
}

Jet LookHead::angle_deg(int axis, double t_s, const Shift& shift) const {
    const auto a = static_cast<std::size_t>(axis);
    const double phase_s = t_s - std::floor(t_s / kCycle_s) * kCycle_s;
    Jet sum{shift.from_deg[a], 0.0, 0.0};
    sum += shift.amplitude_deg[a] * minimum_jerk(phase_s - shift.start_s, shift.duration_s);
    sum += noise_[a].at(t_s);
    return sum;
}

HeadState LookHead::at(double t_s) const {
    const double phase_s = t_s - std::floor(t_s / kCycle_s) * kCycle_s;
    auto next = std::upper_bound(shifts_.begin(), shifts_.end(), phase_s,
                                 [](double t, const Shift& s) { return t < s.start_s; });
    // Before the first shift the head is where that shift starts.
    const Shift& shift = next == shifts_.begin() ? *next : *(next - 1);
    const double to_rad = glm::radians(1.0);
    return head_from_angles(to_rad * angle_deg(0, t_s, shift), to_rad * angle_deg(1, t_s, shift),
                            to_rad * angle_deg(2, t_s, shift));
}

}  // namespace foverig::motion
