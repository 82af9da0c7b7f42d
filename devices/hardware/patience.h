#pragma once
// A request that a device lets run out of time holds up whoever asks, a frame's thread among them.
#include <array>
#include <optional>

#include "devices/result.h"
#include "devices/time.h"

namespace foverig::hardware {

/// After a failure that took long the device is asked nothing for as long again, after the next for
/// four times as long, then for 19: one that stays silent costs its caller a twentieth of its time.
/// One that refuses soon (a stall) may be asked again at once. Not safe for threads.
class Patience {
  public:
    static constexpr Nanoseconds kLong{100'000'000};  ///< a stall takes a millisecond
    static constexpr std::array<int, 3> kRests{1, 4, 19};

    /// not_asked while the device is to be left alone.
    std::optional<Error> spent(HostTime now) const;
    void answered() { in_vain_ = 0; }
    void failed(HostTime asked, HostTime now);

  private:
    std::size_t in_vain_ = 0;  // one after the other
    HostTime rests_until_{HostTime::min()};
};

}  // namespace foverig::hardware
