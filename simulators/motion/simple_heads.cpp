#include "simulators/motion/simple_heads.h"

#include <cmath>
#include <numbers>

#include "devices/head_geometry.h"

namespace foverig::motion {
namespace {

/// A bump of displacement (1 - u^2)^4 that leaves no velocity behind; its peak acceleration is in
/// the middle and points down the bump.
Jet knock(double t_s, double duration_s, double peak_m_s2) {
    const double half_s = 0.5 * duration_s;
    const double u = t_s / half_s;
    if (std::abs(u) >= 1.0) return {};
    const double height_m = peak_m_s2 * half_s * half_s / 8.0;
    const double w = 1.0 - u * u;
    return {height_m * w * w * w * w, height_m * -8.0 * u * w * w * w / half_s,
            height_m * (-8.0 * w * w * w + 48.0 * u * u * w * w) / (half_s * half_s)};
}

}  // namespace

HeadState ShakeHead::at(double t_s) const {
    const double omega_rad_s = 2.0 * std::numbers::pi * settings_.frequency_hz;
    const double sine = std::sin(omega_rad_s * t_s);
    const Jet swing{sine, omega_rad_s * std::cos(omega_rad_s * t_s),
                    -omega_rad_s * omega_rad_s * sine};
    const Jet growth = minimum_jerk(t_s - settings_.rest_s, settings_.growth_s);
    HeadState head =
        head_from_angles(glm::radians(settings_.amplitude_deg) * (growth * swing), {}, {});
    if (settings_.knock_peak_g > 0.0) {
        const Jet jolt = knock(t_s - settings_.knock_time_s, settings_.knock_duration_s,
                               settings_.knock_peak_g * kGravity_m_s2);
        head.position_m.x += jolt.value;
        head.acceleration_m_s2.x += jolt.acceleration;
    }
    return head;
}

HeadState StepHead::at(double t_s) const {
    return head_from_angles(glm::radians(settings_.amplitude_deg) *
                                minimum_jerk(t_s - settings_.start_s, settings_.duration_s),
                            {}, {});
}

}  // namespace foverig::motion
