#pragma once
// One clock type per device, so that a DK2 time cannot be subtracted from a host time.
// All are integer nanoseconds; the epochs differ and only a ClockMap relates them.
#include <chrono>
#include <cstdint>

namespace foverig {

using Nanoseconds = std::chrono::duration<std::int64_t, std::nano>;

struct HostClock {
    using rep = std::int64_t;
    using period = std::nano;
    using duration = Nanoseconds;
};
struct Dk2Clock {
    using rep = std::int64_t;
    using period = std::nano;
    using duration = Nanoseconds;
};
struct GazeClock {
    using rep = std::int64_t;
    using period = std::nano;
    using duration = Nanoseconds;
};

using HostTime = std::chrono::time_point<HostClock, Nanoseconds>;
using Dk2Time = std::chrono::time_point<Dk2Clock, Nanoseconds>;  ///< unwrapped from 2^32 us
using GazeTime = std::chrono::time_point<GazeClock, Nanoseconds>;

/// The run's time. `wall` waits really; `lockstep` moves only when told to.
class Clock {
  public:
    virtual ~Clock() = default;
    virtual HostTime now() const = 0;
    virtual void sleep_until(HostTime deadline) = 0;
};

/// Steady time since construction, `speed` times as fast as it passes.
class WallClock final : public Clock {
  public:
    explicit WallClock(double speed = 1.0);
    HostTime now() const override;
    void sleep_until(HostTime deadline) override;

  private:
    std::chrono::steady_clock::time_point start_;
    double speed_;
};

/// Simulated time: `sleep_until` and `advance` jump, nothing else moves it. Starts at 0.
class ManualClock final : public Clock {
  public:
    HostTime now() const override { return now_; }
    void sleep_until(HostTime deadline) override {
        if (deadline > now_) now_ = deadline;
    }
    void advance(Nanoseconds step) { now_ += step; }

  private:
    HostTime now_{};
};

inline double to_seconds(Nanoseconds d) {
    return std::chrono::duration<double>(d).count();
}
inline double to_ms(Nanoseconds d) {
    return std::chrono::duration<double, std::milli>(d).count();
}
inline Nanoseconds from_seconds(double s) {
    return Nanoseconds(static_cast<std::int64_t>(s * 1e9 + (s < 0 ? -0.5 : 0.5)));
}

}  // namespace foverig
