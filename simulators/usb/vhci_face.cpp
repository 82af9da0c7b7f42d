#include "simulators/usb/vhci_face.h"

namespace foverig::usb {

Result<std::unique_ptr<Face>> VhciFace::plug_in(std::unique_ptr<UsbFunction> function,
                                                std::uint8_t packets, const Clock& clock) {
    auto plugged_in = VhciPort::plug_in(function->descriptors().speed);
    if (!plugged_in) return plugged_in.error();
    return std::unique_ptr<Face>(
        new VhciFace(std::move(function), packets, clock, std::move(plugged_in).value()));
}

VhciFace::VhciFace(std::unique_ptr<UsbFunction> function, std::uint8_t packets, const Clock& clock,
                   VhciPort::PluggedIn plugged_in)
    : function_(std::move(function)),
      packets_(packets),
      server_(std::move(plugged_in.device), *function_, clock),
      port_(std::move(plugged_in.port)) {}

void VhciFace::send(std::vector<std::byte> packet) {
    for (auto& transfer : function_->transfers(std::move(packet))) {
        server_.send(packets_, std::move(transfer));
    }
}

}  // namespace foverig::usb
