#pragma once
// VSyncs from when swaps of buffers return: all that a window system without presentation times
// tells.
#include <cstdint>
#include <deque>
#include <span>

#include "devices/time.h"

namespace foverig {

/// The display's grid where swaps prove to wait for it; a grid of its own at the nominal rate where
/// not. A return is never before its vsync, so that the earliest ones tell the phase; what delays
/// each of them alike cannot be seen.
class VsyncClock {
  public:
    VsyncClock(double nominal_hz, HostTime first);

    /// Returns of swaps with no work between them. They tell the display's grid where they come at
    /// the nominal rate (3 %) and evenly; the first few only fill queues. True if so.
    bool judge(std::span<const HostTime> returns);
    /// A frame's swap has returned. Gives the number of its vsync: never the same twice, and on the
    /// clock's own grid the first one from then on.
    std::uint64_t swapped(HostTime returned);

    bool measured() const { return measured_; }
    double rate_hz() const { return 1.0 / lines_.back().period_s; }
    /// Measured: within it nine of ten returns come after their vsync; else half a period.
    Nanoseconds error() const;

    HostTime vsync(std::uint64_t number) const;
    /// Of the first vsync at or after `at`; never before vsync 0.
    std::uint64_t number_from(HostTime at) const;

  private:
    /// Vsyncs from a number on. What was told of a vsync stands: a new line begins further on.
    struct Line {
        std::uint64_t from;
        std::uint64_t number;
        HostTime at;  ///< of `number`
        double period_s;
    };
    struct Return {
        std::uint64_t number;
        HostTime at;
    };
    HostTime on(const Line& line, std::uint64_t number) const;
    std::uint64_t nearest(HostTime at) const;
    Line fitted();

    double nominal_s_;
    bool measured_ = false;
    std::deque<Line> lines_;
    std::deque<Return> returns_;
    Nanoseconds error_;
    std::uint64_t swaps_ = 0;
};

}  // namespace foverig
