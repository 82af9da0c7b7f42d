#pragma once
// The gaze tracker's bulk frames and vendor requests over libusb (DEVICES.md 4.5.1, 4.5.6).
#include <array>
#include <memory>

#include "devices/hardware/found_device.h"
#include "devices/hardware/link.h"

struct libusb_context;
struct libusb_device_handle;
struct libusb_transfer;

namespace foverig::hardware {

/// Eight asynchronous transfers are queued at all times: a frame is stamped when its transfer ends,
/// by the thread that reads. A halted endpoint is cleared when the device is opened and whenever it
/// halts; what halted comes as an empty packet, which a source counts as rejected. Each link has a
/// libusb context of its own, as one that was made before a device was plugged in may never see it.
class UsbLink final : public Link {
  public:
    /// `device` as found; errors: forbidden, busy, closed, io.
    static Result<std::unique_ptr<Link>> open(const FoundDevice& device);
    ~UsbLink() override;

    Status read(PacketQueue& packets) override;
    Status control_set(std::uint8_t request, std::uint16_t value, Bytes data) override;
    Result<std::vector<std::byte>> control_get(std::uint8_t request, std::uint16_t value,
                                               std::size_t size) override;

  private:
    static constexpr std::size_t kTransfers = 8, kTransferSize = 512;

    struct Close {
        void operator()(libusb_context* context) const;
        void operator()(libusb_device_handle* device) const;
        void operator()(libusb_transfer* transfer) const;
    };
    using Context = std::unique_ptr<libusb_context, Close>;
    using Handle = std::unique_ptr<libusb_device_handle, Close>;
    struct Slot {
        std::unique_ptr<libusb_transfer, Close> transfer;
        std::array<unsigned char, kTransferSize> buffer;
        bool in_flight = false;
    };

    UsbLink(Context context, Handle device, std::string path);

    void start(PacketQueue& packets);
    void submit(Slot& slot);
    void take(Slot& slot);
    void cancel_all();
    bool any_in_flight() const;
    void clear_halt();
    Error failed(int code) const;

    Context context_;
    std::string path_;
    // A control transfer on the other thread may handle the reader's events too.
    std::mutex mutex_;  // of what follows, but for the device
    std::array<Slot, kTransfers> slots_;
    PacketQueue* packets_ = nullptr;  // null: not started
    bool closing_ = false;
    bool halted_ = false;     // to be cleared when no transfer is in flight
    int halts_in_a_row_ = 0;  // without a frame between them
    std::optional<Error> failure_;
    Handle device_;  // last: closing it takes off libusb's list what never ended
};

}  // namespace foverig::hardware
