#include "simulators/faults/device_clock.h"

#include <cmath>

namespace foverig {
namespace {

// A crystal's temperature changes over minutes.
constexpr double kWanderLow_hz = 0.001, kWanderHigh_hz = 0.02;
constexpr int kWanderSines = 12;

}  // namespace

SimulatedDeviceClock::SimulatedDeviceClock(const Settings& settings, std::uint64_t seed)
    : settings_(settings) {
    if (settings.wander_ppm > 0.0) {
        wander_.emplace(motion::Draws(seed, 500), kWanderLow_hz, kWanderHigh_hz,
                        settings.wander_ppm * 1e-6, kWanderSines);
    }
}

void SimulatedDeviceClock::drift(HostTime now, double ppm) {
    const std::int64_t before_ns = at_ns(now);
    settings_.drift_ppm = ppm;
    jump_ += Nanoseconds(before_ns - at_ns(now));
}

std::int64_t SimulatedDeviceClock::at_ns(HostTime t) const {
    const Nanoseconds since = t - settings_.start;
    double ahead_s = settings_.start_s + settings_.drift_ppm * 1e-6 * to_seconds(since);
    if (wander_) ahead_s += wander_->at(to_seconds(since)).value - wander_->at(0.0).value;
    // The long part stays in integers, so that hours do not cost nanoseconds.
    return since.count() + jump_.count() + std::llround(ahead_s * 1e9);
}

}  // namespace foverig
