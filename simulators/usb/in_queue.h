#pragma once
// One endpoint towards the host: transfers that wait for data meet data that wait for a transfer.
#include <deque>
#include <optional>

#include "devices/time.h"
#include "simulators/usb/usbip.h"

namespace foverig::usb {

/// The kernel's usbhid keeps but one transfer in flight, so a device that has no room loses reports
/// between two: here they wait in order, and go when a host that is slower than the device has let
/// them become old. Not safe for threads.
class InQueue {
  public:
    /// A host that asked for nothing this long is not listening: what was kept for it is old, and
    /// is thrown away.
    static constexpr Nanoseconds kListens{500'000'000};
    static constexpr Nanoseconds kOldest{1'000'000'000};  ///< that a packet becomes here

    /// A transfer that has ended.
    struct Ended {
        Submit submit;
        std::int32_t status = kGood;
        std::vector<std::byte> data;
    };

    std::optional<Ended> submit(const Submit& submit, HostTime now);
    std::optional<Ended> push(std::vector<std::byte> data, HostTime now);
    /// False: no such transfer waits here.
    bool unlink(std::uint32_t sequence);

    std::uint64_t unheard() const { return unheard_; }  ///< packets that nobody asked for in time

  private:
    std::optional<Ended> meet();

    struct Kept {
        HostTime since;
        std::vector<std::byte> data;
    };

    std::deque<Submit> waiting_;
    std::deque<Kept> kept_;
    HostTime last_asked_{HostTime::min()};
    std::uint64_t unheard_ = 0;
};

}  // namespace foverig::usb
