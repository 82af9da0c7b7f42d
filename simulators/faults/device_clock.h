#pragma once
// A device's clock as a function of true (host) time: offset, drift and slow wander.
#include <cstdint>
#include <optional>

#include "devices/time.h"
#include "simulators/motion/band_noise.h"

namespace foverig {

class SimulatedDeviceClock {
  public:
    struct Settings {
        HostTime start{};      ///< when the device was plugged in
        double start_s = 0.0;  ///< what its clock read then
        double drift_ppm = 0.0;
        double wander_ppm = 0.0;  ///< root mean square of the rate's slow changes
    };
    SimulatedDeviceClock(const Settings& settings, std::uint64_t seed);

    /// Nanoseconds on the device's own clock.
    std::int64_t at_ns(HostTime t) const;
    /// The clock jumps by this much now and stays ahead.
    void jump(Nanoseconds step) { jump_ += step; }
    /// From `now` on it drifts by this much.
    void drift(HostTime now, double ppm);

  private:
    Settings settings_;
    Nanoseconds jump_{0};
    std::optional<motion::BandNoise> wander_;
};

}  // namespace foverig
