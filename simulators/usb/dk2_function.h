#pragma once
// A DK2 as its host's USB sees it (DEVICES.md 1.1): HID, full speed, one interrupt endpoint.
#include "devices/transport.h"
#include "simulators/usb/usb_function.h"

namespace foverig::usb {

class Dk2Function final : public UsbFunction {
  public:
    static constexpr std::uint16_t kRelease = 0x0212;  ///< of boards of Rev3.3
    static constexpr std::uint8_t kReports = 1;        ///< the endpoint of input reports

    /// `device` gives and takes feature reports; it outlives the function and is safe for threads.
    explicit Dk2Function(Transport& device);

    const Descriptors& descriptors() const override { return descriptors_; }
    std::optional<std::vector<std::byte>> answer(const Setup& setup) override;
    bool take(const Setup& setup, Bytes data) override;

  private:
    Transport& device_;
    Descriptors descriptors_;
};

/// On USB: the UUID of feature report 19, empty where the device does not tell it.
std::string dk2_serial(Transport& device);

}  // namespace foverig::usb
