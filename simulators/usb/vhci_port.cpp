#include "simulators/usb/vhci_port.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace foverig::usb {
namespace {

constexpr int kFree = 4;  // VDEV_ST_NULL of the kernel's usbip_common.h
constexpr int kBus = 1;

/// 0 or errno.
int write_text(const std::filesystem::path& file, const std::string& text) {
    const FileHandle handle(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
    if (handle.get() < 0) return errno;
    return ::write(handle.get(), text.data(), text.size()) < 0 ? errno : 0;
}

Error problem(const std::filesystem::path& attach, int reason) {
    if (reason == EACCES || reason == EPERM || reason == EROFS) {
        return {
            ErrorCode::forbidden,
            fmt::format("{} may not be written by this user; run the same command as root (sudo)",
                        attach.string())};
    }
    if (reason == EBUSY) {
        return {ErrorCode::busy, fmt::format("{}: every port is taken; unplug another device first",
                                             attach.parent_path().string())};
    }
    return {ErrorCode::io,
            fmt::format("{} takes no device: {}", attach.string(), std::strerror(reason))};
}

}  // namespace

std::vector<int> free_ports(std::string_view status) {
    std::istringstream lines{std::string(status)};
    std::vector<int> ports;
    std::string line, hub;
    while (std::getline(lines, line)) {
        std::istringstream fields(line);
        int port = 0, state = 0;
        if (fields >> hub >> port >> state && hub == "hs" && state == kFree) ports.push_back(port);
    }
    return ports;
}

Result<VhciPort::PluggedIn> VhciPort::plug_in(Speed speed, const std::filesystem::path& sysfs) {
    std::ifstream status(sysfs / "status");
    if (!status) {
        return Error{ErrorCode::not_found,
                     fmt::format("this kernel has no virtual USB host controller ({} is missing); "
                                 "load it: sudo modprobe vhci-hcd",
                                 sysfs.string())};
    }
    const std::string text{std::istreambuf_iterator<char>(status), {}};
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
        return problem(sysfs / "attach", errno);
    }
    FileHandle device(ends[0]);
    const FileHandle host(ends[1]);  // the kernel keeps its own hold on it
    int reason = EBUSY;
    for (const int port : free_ports(text)) {
        reason = write_text(sysfs / "attach",
                            fmt::format("{} {} {} {}", port, host.get(), kBus << 16 | (port + 1),
                                        static_cast<int>(speed)));
        if (reason == 0) return PluggedIn{VhciPort(sysfs, port), std::move(device)};
        if (reason != EBUSY) break;  // busy: another program was faster; the next port
    }
    return problem(sysfs / "attach", reason);
}

VhciPort::VhciPort(VhciPort&& other) noexcept
    : sysfs_(std::move(other.sysfs_)), port_(std::exchange(other.port_, -1)) {}

VhciPort::~VhciPort() {
    if (port_ >= 0) write_text(sysfs_ / "detach", std::to_string(port_));
}

}  // namespace foverig::usb
