#pragma once
// A request that a device lets run out of time holds up whoever asks, a frame's thread among them.
#include <optional>

#include "devices/result.h"
#include "devices/time.h"

namespace foverig::hardware {

/// After a failure that took long the device is asked nothing for 19 times as long: requests in
/// vain cost their caller a twentieth of its time at most. One that refuses soon (a stall) may be
/// asked again at once. Not safe for threads.
class Patience {
  public:
    static constexpr Nanoseconds kLong{100'000'000};  ///< a stall takes a millisecond
    static constexpr int kRest = 19;

    /// io while the device is to be left alone.
    std::optional<Error> spent(HostTime now) const;
    void failed(HostTime asked, HostTime now);

  private:
    HostTime rests_until_{HostTime::min()};
};

}  // namespace foverig::hardware
