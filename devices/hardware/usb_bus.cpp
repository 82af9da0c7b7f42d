#include "devices/hardware/usb_bus.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "devices/hardware/first_line.h"
#include "devices/hardware/holders.h"

namespace foverig::hardware {
namespace {

namespace fs = std::filesystem;

/// The kernel may be taking this tree down just now: what is gone has no node.
bool has_node(const fs::path& usb, const std::string& kind) {
    std::error_code error;
    fs::recursive_directory_iterator at(usb, error);
    for (; !error && at != end(at); at.increment(error)) {  // of a range-for, ++ throws
        if (at->path().filename() == kind) return true;
    }
    return false;
}

/// Of interface 0; empty: none has it.
std::string driver_of(const fs::path& usb) {
    std::error_code error;
    const fs::path driver = usb / (usb.filename().string() + ":1.0") / "driver";
    return fs::read_symlink(driver, error).filename().string();
}

std::string node_of(const fs::path& usb) {
    return fmt::format("/dev/bus/usb/{:03}/{:03}", std::atoi(first_line_of(usb / "busnum").c_str()),
                       std::atoi(first_line_of(usb / "devnum").c_str()));
}

Error problem_of(const fs::path& usb, const std::string& node, const std::string& kind) {
    const std::string driver = driver_of(usb);
    if (driver == "usbfs") {
        Error error = busy(node);
        error.text += fmt::format(" (the kernel has no {} of it meanwhile)", kind);
        return error;
    }
    if (driver.empty()) {
        return {ErrorCode::io,
                fmt::format("{} is on the bus, but no driver of the kernel has it: a program took "
                            "it and did not give it back, or the driver is not loaded; plug it in "
                            "again",
                            node)};
    }
    return {ErrorCode::io, fmt::format("{} is on the bus, but its driver {} makes no {} of it; use "
                                       "a kernel that has {}",
                                       node, driver, kind, kind)};
}

}  // namespace

std::vector<FoundDevice> find_without_node(const UsbId& id, const std::string& kind,
                                           const std::string& sysfs) {
    std::vector<fs::path> devices;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(sysfs, error)) {
        const fs::path usb = fs::canonical(entry.path(), error);
        if (usb_id_of(first_line_of(usb / "idVendor") + ":" + first_line_of(usb / "idProduct")) ==
            id)
            devices.push_back(usb);
    }
    std::sort(devices.begin(), devices.end());
    std::vector<FoundDevice> found;
    for (const fs::path& usb : devices) {
        if (has_node(usb, kind)) continue;
        const std::string node = node_of(usb);
        found.push_back({node, first_line_of(usb / "serial"), problem_of(usb, node, kind)});
    }
    return found;
}

}  // namespace foverig::hardware
