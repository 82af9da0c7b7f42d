#pragma once
// A port of the kernel's virtual USB host controller (vhci-hcd, sysfs).
#include <filesystem>
#include <string_view>

#include "simulators/usb/file_handle.h"
#include "simulators/usb/usb_function.h"

namespace foverig::usb {

/// Numbers of the free ports that take devices up to high speed, of the text of `status`.
std::vector<int> free_ports(std::string_view status);

/// A device is plugged in from `plug_in` to the port's end.
class VhciPort {
  public:
    static constexpr const char* kSysfs = "/sys/devices/platform/vhci_hcd.0";

    struct PluggedIn;
    /// Errors: not_found (no such module in the kernel), forbidden, busy (no free port), io.
    static Result<PluggedIn> plug_in(Speed speed, const std::filesystem::path& sysfs = kSysfs);

    VhciPort(VhciPort&& other) noexcept;
    VhciPort& operator=(VhciPort&&) = delete;
    ~VhciPort();

  private:
    VhciPort(std::filesystem::path sysfs, int port) : sysfs_(std::move(sysfs)), port_(port) {}

    std::filesystem::path sysfs_;
    int port_;  // -1: moved from
};

struct VhciPort::PluggedIn {
    VhciPort port;
    FileHandle device;  ///< the device's end of the socket
};

}  // namespace foverig::usb
