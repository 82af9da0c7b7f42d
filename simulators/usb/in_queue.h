#pragma once
// One endpoint towards the host: transfers that wait for data meet data that wait for a transfer.
#include <deque>
#include <optional>

#include "devices/time.h"
#include "simulators/usb/usbip.h"

namespace foverig::usb {

/// The kernel's usbhid keeps but one transfer in flight, so a device that has no room loses reports
/// between two: here they wait in order. Not safe for threads.
class InQueue {
  public:
    /// A host that asked for nothing this long is not listening: what was kept for it is old, and
    /// is thrown away.
    static constexpr Nanoseconds kListens{500'000'000};

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

    std::uint64_t unheard() const { return unheard_; }  ///< packets that nobody asked for

  private:
    std::optional<Ended> meet();

    std::deque<Submit> waiting_;
    std::deque<std::vector<std::byte>> data_;
    HostTime last_asked_{HostTime::min()};
    std::uint64_t unheard_ = 0;
};

}  // namespace foverig::usb
