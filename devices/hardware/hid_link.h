#pragma once
// The DK2's inertial sensor and features over hidapi's hidraw back end.
#include <memory>

#include "devices/hardware/found_device.h"
#include "devices/hardware/link.h"

struct hid_device_;

namespace foverig::hardware {

/// Opened twice: one handle reads, the other carries feature reports, so that a slow control
/// transfer holds no input report up. Repeats the last keep-alive (report 17) from the reader
/// thread, so that a host which is busy for long does not let the headset fall asleep (DEVICES.md
/// 1.6).
class HidLink final : public Link {
  public:
    /// `device` as found; errors: forbidden, busy, closed, io.
    static Result<std::unique_ptr<Link>> open(const FoundDevice& device);

    Status read(PacketQueue& packets) override;
    /// The whole report, id included; `value` means nothing to a HID device.
    Status control_set(std::uint8_t id, std::uint16_t value, Bytes report) override;
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override;

  private:
    struct Close {
        void operator()(hid_device_* device) const;
    };
    using Handle = std::unique_ptr<hid_device_, Close>;

    HidLink(Handle input, Handle features, std::string path);

    void keep_alive();
    Status send(Bytes report);

    Handle input_;
    std::string path_;
    std::mutex mutex_;  // of all below
    Handle features_;
    std::vector<std::byte> last_keep_alive_;  // empty: the host never asked for one
    std::chrono::steady_clock::time_point last_set_{};
};

}  // namespace foverig::hardware
