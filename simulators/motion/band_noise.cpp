#include "simulators/motion/band_noise.h"

#include <cmath>
#include <numbers>

namespace foverig::motion {

BandNoise::BandNoise(const Draws& draws, double low_hz, double high_hz, double rate_rms,
                     int sines) {
    const double width_hz = (high_hz - low_hz) / sines;
    const double rate_amplitude = rate_rms * std::sqrt(2.0 / sines);
    for (int i = 0; i < sines; ++i) {
        const auto index = static_cast<std::uint64_t>(2 * i);
        const double omega_rad_s =
            2.0 * std::numbers::pi * (low_hz + (i + draws.uniform(index)) * width_hz);
        sines_.push_back({omega_rad_s, 2.0 * std::numbers::pi * draws.uniform(index + 1),
                          rate_amplitude / omega_rad_s});
    }
}

Jet BandNoise::at(double t_s) const {
    Jet sum;
    for (const Sine& sine : sines_) {
        const double angle = sine.omega_rad_s * t_s + sine.phase_rad;
        const double value = sine.amplitude * std::sin(angle);
        sum += {value, sine.amplitude * sine.omega_rad_s * std::cos(angle),
                -sine.omega_rad_s * sine.omega_rad_s * value};
    }
    return sum;
}

}  // namespace foverig::motion
