#pragma once
// When a headset that falls asleep is due another keep-alive; no I/O.
#include "devices/hardware/patience.h"

namespace foverig::hardware {

/// Due a period after the last report that the device took, whatever was tried since. A keep-alive
/// that ran out of time is followed by one at once, as the device may be about to fall asleep; from
/// the second lost in a row on they rest as Patience has it, and one that was refused soon (a
/// stall) by a period. Not safe for threads.
class KeepAlivePace {
  public:
    explicit KeepAlivePace(HostTime start) : last_taken_(start), last_refused_(start) {}

    void set_period(Nanoseconds period) { period_ = period; }
    bool due(HostTime now) const;
    /// Any report, at the end of its way.
    void taken(HostTime now) { last_taken_ = now; }
    void keep_alive_taken(HostTime now);
    /// A keep-alive; `asked`: when it set out.
    void keep_alive_failed(HostTime asked, HostTime now);

  private:
    Nanoseconds period_{};
    HostTime last_taken_;
    HostTime last_refused_;
    bool lost_before_ = false;  // the keep-alive before this
    Patience patience_;
};

}  // namespace foverig::hardware
