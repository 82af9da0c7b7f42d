#pragma once
// A scalar of time with its first two derivatives, and the two shapes motion is built of.
#include <algorithm>

namespace foverig::motion {

struct Jet {
    double value = 0.0;
    double rate = 0.0;          ///< per second
    double acceleration = 0.0;  ///< per second squared

    Jet& operator+=(const Jet& other) {
        value += other.value;
        rate += other.rate;
        acceleration += other.acceleration;
        return *this;
    }
    friend Jet operator*(const Jet& a, const Jet& b) {
        return {a.value * b.value, a.rate * b.value + a.value * b.rate,
                a.acceleration * b.value + 2.0 * a.rate * b.rate + a.value * b.acceleration};
    }
    friend Jet operator*(double factor, const Jet& jet) {
        return {factor * jet.value, factor * jet.rate, factor * jet.acceleration};
    }
};

/// Peak speed of a minimum-jerk step of length 1 in 1 s (Flash and Hogan's polynomial).
inline constexpr double kMinimumJerkPeak = 1.875;

/// Minimum-jerk step from 0 to 1 that starts at 0 and takes `duration_s`.
inline Jet minimum_jerk(double t_s, double duration_s) {
    const double u = std::clamp(t_s / duration_s, 0.0, 1.0);
    const double rest = 1.0 - u;
    return {u * u * u * (10.0 + u * (-15.0 + 6.0 * u)), 30.0 * u * u * rest * rest / duration_s,
            60.0 * u * rest * (1.0 - 2.0 * u) / (duration_s * duration_s)};
}

}  // namespace foverig::motion
