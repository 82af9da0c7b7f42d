#pragma once
// A camera as its host's USB sees it: UVC, and for the DK2's tracker camera the bridge chip's
// extension unit (DEVICES.md 1.8).
#include <atomic>

#include "devices/transport.h"
#include "simulators/usb/camera_descriptors.h"
#include "simulators/usb/usb_function.h"

namespace foverig::usb {

class CameraFunction final : public UsbFunction {
  public:
    /// `device` answers the extension unit; it outlives the function and is safe for threads.
    explicit CameraFunction(Transport& device, const CameraTraits& traits = dk2_camera());

    const Descriptors& descriptors() const override { return descriptors_; }
    std::optional<std::vector<std::byte>> answer(const Setup& setup) override;
    bool take(const Setup& setup, Bytes data) override;
    /// A frame (camera/frame.h) in payloads; none until the host has asked for a stream.
    std::vector<std::vector<std::byte>> transfers(std::vector<std::byte> packet) override;

  private:
    bool is_extension(const Setup& setup) const;
    std::optional<std::vector<std::byte>> answer_unit(const Setup& setup);

    Transport& device_;
    CameraTraits traits_;
    Descriptors descriptors_;
    std::atomic<bool> streams_{false};
    std::uint8_t frame_id_ = 0;  // toggles from frame to frame
};

}  // namespace foverig::usb
