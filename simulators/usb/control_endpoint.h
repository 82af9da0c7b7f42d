#pragma once
// Endpoint 0: the standard requests of USB 2.0 (9.4), for any device.
#include "simulators/usb/usb_function.h"

namespace foverig::usb {

class ControlEndpoint {
  public:
    explicit ControlEndpoint(UsbFunction& function) : function_(function) {}

    /// Data for the host, cut to what it asked for; nothing: it stalls.
    std::optional<std::vector<std::byte>> answer(const Setup& setup);
    bool take(const Setup& setup, Bytes data);

  private:
    std::optional<std::vector<std::byte>> descriptor(std::uint16_t value) const;

    UsbFunction& function_;
    std::uint8_t configuration_ = 0;
};

}  // namespace foverig::usb
