#pragma once
// Device clock -> host clock from stamped arrivals. Transport delays are one-sided, so the lower
// envelope of (arrival - device stamp) is the unbiased part (DEVICES.md 3.2): per-window minima are
// kept and the line under all of them with the least total distance gives offset and drift
// (Moon, Skelly, Towsley 1999). Constant smallest delay stays in the result.
#include <cstdint>
#include <optional>
#include <vector>

#include "devices/ring.h"
#include "devices/time.h"

namespace foverig {

struct ClockMapConfig {
    Nanoseconds window{500'000'000};  ///< one minimum is kept per window
    std::size_t windows = 60;         ///< how many; 30 s see 20 ppm through 1 ms of jitter
    Nanoseconds jump{8'000'000};      ///< a larger step of the envelope starts again
    double max_slew = 0.004;          ///< fastest correction, s/s; keeps the map monotone
    double max_drift = 500e-6;        ///< slopes beyond a crystal's are not believed
};

/// The arithmetic in plain nanoseconds; use ClockMap<DeviceTime>.
class SkewTracker {
  public:
    explicit SkewTracker(const ClockMapConfig& config)
        : config_(config), minima_(config.windows + 1) {}

    void update(std::int64_t device_ns, std::int64_t arrival_ns);
    void reset();
    bool ready() const { return ready_; }
    std::int64_t to_host(std::int64_t device_ns) const;

    double drift() const { return slope_; }  ///< host seconds gained per device second
    std::int64_t residual_ns() const { return residual_ns_; }
    std::uint64_t resets() const { return resets_; }

  private:
    struct Point {
        std::int64_t device_ns;
        double skew_ns;
    };

    void start(const Point& p);
    void close_window();
    void fit();
    double target(std::int64_t device_ns) const;

    ClockMapConfig config_;
    bool ready_ = false;
    Ring<Point> minima_;
    std::optional<Point> open_;  // smallest of the window that is filling
    std::int64_t window_start_ns_ = 0;
    std::int64_t origin_host_ns_ = 0, origin_device_ns_ = 0;  // skews are relative to these
    Point fitted_{};                                          // the line goes through it ...
    double slope_ = 0;                                        // ... with this slope
    Point before_{}, now_{};  // the applied skew at the last two updates
    std::int64_t residual_ns_ = 0;
    std::uint64_t resets_ = 0;
    std::vector<Point> points_, hull_;  // of `fit` alone; their memory is kept
};

/// Monotone between resets for stamps up to the newest update; may be asked for any stamp.
template <class DeviceTime>
class ClockMap {
  public:
    explicit ClockMap(const ClockMapConfig& config = {}) : tracker_(config) {}

    /// A packet stamped `device` was there at `arrival`. Stamps may come slightly out of order.
    void update(DeviceTime device, HostTime arrival) {
        tracker_.update(device.time_since_epoch().count(), arrival.time_since_epoch().count());
    }
    /// Forgets everything: the device's clock started again.
    void reset() { tracker_.reset(); }
    /// Whether there was an update since the last reset; `to_host` needs it.
    bool ready() const { return tracker_.ready(); }
    HostTime to_host(DeviceTime device) const {
        return HostTime(Nanoseconds(tracker_.to_host(device.time_since_epoch().count())));
    }
    double drift() const { return tracker_.drift(); }
    /// How far the kept minima lie above the line, on average: the map's own uncertainty.
    Nanoseconds residual() const { return Nanoseconds(tracker_.residual_ns()); }
    std::uint64_t resets() const { return tracker_.resets(); }

  private:
    SkewTracker tracker_;
};

}  // namespace foverig
