#pragma once
// The DK2's 32-bit microseconds as 64-bit time (DEVICES.md 1.2, 3.2, 3.3).
#include <cstdint>

#include "devices/time.h"

namespace foverig::dk2 {

class StampUnwrapper {
  public:
    enum class Verdict {
        accepted,   ///< later than the one before, across the wrap at 71 min too
        duplicate,  ///< the same stamp again
        backwards,  ///< more than 2^31 us "ahead": an old report; time stands
        restarted   ///< the first after expect_restart, or many backwards stamps in order: the
                    ///< device began anew; time goes on from there
    };

    Verdict advance(std::uint32_t stamp_us);
    /// The device was gone: whatever stamp comes next is of a clock that may have begun anew.
    void expect_restart() { restart_expected_ = started_; }

    /// Of the newest accepted stamp.
    Dk2Time now() const { return Dk2Time(Nanoseconds(now_us_ * 1000)); }
    /// Of a frame or exposure stamp: at most 2^24 us (17 s) after `now`, else before it.
    Dk2Time near(std::uint32_t stamp_us) const;

  private:
    static constexpr int kRestartAfter = 16;

    bool started_ = false;
    bool restart_expected_ = false;
    std::int64_t now_us_ = 0;  // its low 32 bits are the stamp
    std::uint32_t last_backwards_us_ = 0;
    int backwards_in_order_ = 0;
};

}  // namespace foverig::dk2
