#pragma once
// The gaze tracker as its host's USB sees it (DEVICES.md 4.5.1): one vendor interface, one bulk
// endpoint. The heartbeat's optional interrupt endpoint is not there.
#include "devices/transport.h"
#include "simulators/usb/descriptors.h"
#include "simulators/usb/usb_function.h"

namespace foverig::usb {

class GazeFunction final : public UsbFunction {
  public:
    static constexpr std::uint8_t kFrames = 1;  ///< the endpoint of SGZ1 frames

    /// `device` answers vendor requests; it outlives the function and is safe for threads.
    GazeFunction(Transport& device, const DeviceIdentity& identity);

    const Descriptors& descriptors() const override { return descriptors_; }
    std::optional<std::vector<std::byte>> answer(const Setup& setup) override;
    bool take(const Setup& setup, Bytes data) override;

  private:
    Transport& device_;
    Descriptors descriptors_;
};

}  // namespace foverig::usb
