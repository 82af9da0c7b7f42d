#pragma once
// The DK2's inertial sensor and features over hidapi's hidraw back end.
#include <memory>

#include "devices/hardware/found_device.h"
#include "devices/hardware/keep_alive_pace.h"
#include "devices/hardware/link.h"

struct hid_device_;

namespace foverig::hardware {

/// Opened twice: one handle reads, the other carries feature reports, so that a slow control
/// transfer holds no input report up.
class HidLink final : public Link {
  public:
    /// `device` as found; errors: forbidden, busy, closed, io.
    static Result<std::unique_ptr<Link>> open(const FoundDevice& device);

    Status read(PacketQueue& packets) override;
    /// The whole report, id included; `value` means nothing to a HID device.
    Status control_set(std::uint8_t id, std::uint16_t value, Bytes report) override;
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override;
    /// Any report that the device took counts: the next keep-alive is `period` after the last of
    /// them. One that runs out of time holds `read` up: the next sets out at once, later ones rest
    /// as KeepAlivePace has it, apart from what others ask, so that a headset which takes them is
    /// not let sleep for a request that it lost.
    void keep_awake(std::uint8_t id, Bytes report, Nanoseconds period) override;

  private:
    struct Close {
        void operator()(hid_device_* device) const;
    };
    using Handle = std::unique_ptr<hid_device_, Close>;

    HidLink(Handle input, Handle features, std::string path);

    void keep_alive_if_due();
    Status send(Bytes report);

    Handle input_;
    std::string path_;
    std::mutex mutex_;  // of all below
    Handle features_;
    std::vector<std::byte> keep_alive_;  // empty: nobody asked for it
    WallClock clock_;
    KeepAlivePace pace_{clock_.now()};
};

}  // namespace foverig::hardware
