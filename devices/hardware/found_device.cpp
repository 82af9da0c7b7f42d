#include "devices/hardware/found_device.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "devices/hardware/holders.h"

namespace foverig::hardware {
namespace {

std::string serials_of(const std::vector<FoundDevice>& found) {
    std::vector<std::string> serials;
    for (const FoundDevice& device : found) {
        serials.push_back(device.serial.empty() ? device.path + " (serial unknown)"
                                                : device.serial);
    }
    return fmt::format("{}", fmt::join(serials, ", "));
}

}  // namespace

Error forbidden(const std::string& path) {
    return {
        ErrorCode::forbidden,
        fmt::format("{} may not be opened by this user; install the udev rule ({}) and plug the "
                    "device in again",
                    path, kInstallUdevRule)};
}

std::optional<Error> opening_problem(const std::string& path) {
    const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (file >= 0) {
        ::close(file);
        return std::nullopt;
    }
    const int reason = errno;
    switch (reason) {
        case EACCES:
        case EPERM:
            return forbidden(path);
        case EBUSY:
            return busy(path);
        case ENOENT:
        case ENODEV:
        case ENXIO:
            return Error{ErrorCode::closed, fmt::format("{} was unplugged just now", path)};
        default:
            return Error{ErrorCode::io,
                         fmt::format("{} cannot be opened: {}", path, std::strerror(reason))};
    }
}

Result<FoundDevice> choose(const std::vector<FoundDevice>& found, const std::string& serial,
                           const std::string& kind, const std::string& looked_for) {
    if (found.empty()) {
        return Error{ErrorCode::not_found,
                     fmt::format("no {} found: looked for a {}; plug it in (foverig doctor says "
                                 "what is seen)",
                                 kind, looked_for)};
    }
    if (serial.empty()) {
        if (found.size() == 1) return found.front();
        return Error{ErrorCode::invalid_data,
                     fmt::format("{} {}s found ({}); name one by its serial", found.size(), kind,
                                 serials_of(found))};
    }
    const auto named = std::find_if(found.begin(), found.end(),
                                    [&](const FoundDevice& d) { return d.serial == serial; });
    if (named != found.end()) return *named;
    return Error{ErrorCode::not_found, fmt::format("no {} of serial {} found; there is {}", kind,
                                                   serial, serials_of(found))};
}

}  // namespace foverig::hardware
