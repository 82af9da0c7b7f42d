#pragma once
#include "simulators/usb/face.h"
#include "simulators/usb/usb_server.h"
#include "simulators/usb/vhci_port.h"

namespace foverig::usb {

/// A USB device of the kernel's virtual host controller, all the kernel's drivers above it.
class VhciFace final : public Face {
  public:
    /// `packets`: the endpoint that they go to. Errors as VhciPort::plug_in. `clock` outlives the
    /// face.
    static Result<std::unique_ptr<Face>> plug_in(std::unique_ptr<UsbFunction> function,
                                                 std::uint8_t packets, const Clock& clock);

    void send(std::vector<std::byte> packet) override;
    std::uint64_t unheard() const override { return server_.unheard(); }
    bool connected() const override { return server_.connected(); }

  private:
    VhciFace(std::unique_ptr<UsbFunction> function, std::uint8_t packets, const Clock& clock,
             VhciPort::PluggedIn plugged_in);

    std::unique_ptr<UsbFunction> function_;
    std::uint8_t packets_;
    UsbServer server_;
    VhciPort port_;  // last: the kernel lets go before the server does
};

}  // namespace foverig::usb
