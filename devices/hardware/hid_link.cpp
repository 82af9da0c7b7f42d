#include "devices/hardware/hid_link.h"

#include <fmt/format.h>
#include <hidapi/hidapi.h>

#include <array>

#include "devices/hardware/holders.h"
#include "devices/hardware/usb_bus.h"

namespace foverig::hardware {
namespace {

constexpr std::size_t kLargestInputReport = 64;
constexpr int kWait_ms = 50;  // how soon the reader sees that it should stop

std::string ascii(const wchar_t* text) {
    std::string out;
    for (; text != nullptr && *text != 0; ++text) {
        out += *text >= 0x20 && *text < 0x7F ? static_cast<char>(*text) : '?';
    }
    return out;
}

unsigned char* raw(std::byte* bytes) {
    return reinterpret_cast<unsigned char*>(bytes);
}
const unsigned char* raw(const std::byte* bytes) {
    return reinterpret_cast<const unsigned char*>(bytes);
}

/// The kernel lets any number of programs open a hidraw node, and none of them would know.
std::optional<Error> problem_of(const std::string& path) {
    if (auto problem = opening_problem(path)) return problem;
    const auto holders = holders_of(path);
    if (holders.empty()) return std::nullopt;
    return busy(path, holders);
}

}  // namespace

std::vector<FoundDevice> find_headsets() {
    std::vector<FoundDevice> found;
    hid_device_info* all = hid_enumerate(kDk2.vendor, kDk2.product);
    for (const hid_device_info* info = all; info != nullptr; info = info->next) {
        if (info->path == nullptr) continue;  // its node is just going
        const std::string path = info->path;
        const bool known = !found.empty() && found.back().path == path;  // a row for each usage
        if (!known) found.push_back({path, ascii(info->serial_number), problem_of(path)});
    }
    hid_free_enumeration(all);
    for (FoundDevice& device : find_without_node(kDk2, "hidraw")) found.push_back(device);
    return found;
}

void HidLink::Close::operator()(hid_device_* device) const {
    hid_close(device);
}

Result<std::unique_ptr<Link>> HidLink::open(const FoundDevice& device) {
    if (device.problem) return *device.problem;
    if (const auto problem = opening_problem(device.path)) return *problem;
    Handle input(hid_open_path(device.path.c_str()));
    Handle features(hid_open_path(device.path.c_str()));
    if (!input || !features) {
        return Error{ErrorCode::io, fmt::format("{} cannot be opened: {}", device.path,
                                                ascii(hid_error(nullptr)))};
    }
    return std::unique_ptr<Link>(new HidLink(std::move(input), std::move(features), device.path));
}

HidLink::HidLink(Handle input, Handle features, std::string path)
    : input_(std::move(input)), path_(std::move(path)), features_(std::move(features)) {}

Status HidLink::read(PacketQueue& packets) {
    std::array<std::byte, kLargestInputReport> report;
    const int size = hid_read_timeout(input_.get(), raw(report.data()), report.size(), kWait_ms);
    if (size < 0) {
        return Error{ErrorCode::closed,
                     fmt::format("{} gives no more reports ({}): the headset was "
                                 "unplugged",
                                 path_, ascii(hid_error(input_.get())))};
    }
    if (size > 0) packets.push(Bytes(report).first(static_cast<std::size_t>(size)));
    keep_alive_if_due();
    return Done{};
}

void HidLink::keep_awake(std::uint8_t, Bytes report, Nanoseconds period) {
    const std::lock_guard lock(mutex_);
    keep_alive_ = to_vector(report);
    pace_.set_period(period);
}

void HidLink::keep_alive_if_due() {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock || keep_alive_.empty()) return;  // locked: a report goes over just now
    const HostTime asked = clock_.now();
    if (!pace_.due(asked)) return;
    // A failure shows where it matters: reports stop.
    if (send(keep_alive_)) {
        pace_.keep_alive_taken(clock_.now());
    } else {
        pace_.keep_alive_failed(asked, clock_.now());
    }
}

Status HidLink::send(Bytes report) {
    const int sent = hid_send_feature_report(features_.get(), raw(report.data()), report.size());
    if (sent >= 0) return Done{};
    return Error{ErrorCode::io, fmt::format("{} did not take feature report {}: {}", path_,
                                            read_u8(report, 0), ascii(hid_error(features_.get())))};
}

Status HidLink::control_set(std::uint8_t id, std::uint16_t, Bytes report) {
    if (report.empty() || read_u8(report, 0) != id) {
        return Error{ErrorCode::invalid_data,
                     fmt::format("feature report {} does not start with its id", id)};
    }
    const std::lock_guard lock(mutex_);
    const Status sent = send(report);
    if (sent) pace_.taken(clock_.now());
    return sent;
}

Result<std::vector<std::byte>> HidLink::control_get(std::uint8_t id, std::uint16_t,
                                                    std::size_t size) {
    std::vector<std::byte> report(std::max<std::size_t>(size, 1));
    report[0] = std::byte{id};
    const std::lock_guard lock(mutex_);
    const int got = hid_get_feature_report(features_.get(), raw(report.data()), report.size());
    if (got < 0) {
        return Error{ErrorCode::io, fmt::format("{} did not give feature report {}: {}", path_, id,
                                                ascii(hid_error(features_.get())))};
    }
    report.resize(static_cast<std::size_t>(got));
    return report;
}

}  // namespace foverig::hardware
