#include "simulators/usb/uhid_face.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/uhid.h>
#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>

#include "devices/bytes.h"

namespace foverig::usb {
namespace {

constexpr int kWait_ms = 100;  // how soon the thread sees that it should stop
constexpr std::uint16_t kUsbBus = 3;
constexpr std::size_t kLargestReport = 64 + 16;

template <std::size_t N>
void copy_text(__u8 (&to)[N], const std::string& text) {
    std::memcpy(to, text.data(), std::min(text.size(), N - 1));
}

Error problem(int reason) {
    if (reason == ENOENT || reason == ENODEV || reason == ENXIO) {
        return {ErrorCode::not_found,
                fmt::format("this kernel makes no HID devices ({} is missing); load the module: "
                            "sudo modprobe uhid",
                            UhidFace::kNode)};
    }
    if (reason == EACCES || reason == EPERM) {
        return {
            ErrorCode::forbidden,
            fmt::format("{} may not be opened by this user; run the same command as root (sudo)",
                        UhidFace::kNode)};
    }
    return {ErrorCode::io,
            fmt::format("{} makes no device: {}", UhidFace::kNode, std::strerror(reason))};
}

uhid_event creation(const HidIdentity& identity) {
    uhid_event event{};
    event.type = UHID_CREATE2;
    auto& create = event.u.create2;
    copy_text(create.name, identity.name);
    copy_text(create.uniq, identity.serial);
    create.bus = kUsbBus;
    create.vendor = identity.vendor;
    create.product = identity.product;
    create.version = identity.release;
    create.rd_size = static_cast<__u16>(identity.report_descriptor.size());
    std::memcpy(create.rd_data, identity.report_descriptor.data(), create.rd_size);
    return event;
}

}  // namespace

Result<std::unique_ptr<Face>> UhidFace::plug_in(Transport& device, const HidIdentity& identity) {
    FileHandle uhid(::open(kNode, O_RDWR | O_CLOEXEC));
    if (uhid.get() < 0) return problem(errno);
    const uhid_event event = creation(identity);
    if (::write(uhid.get(), &event, sizeof event) < 0) return problem(errno);
    return std::unique_ptr<Face>(new UhidFace(std::move(uhid), device));
}

UhidFace::UhidFace(FileHandle uhid, Transport& device)
    : uhid_(std::move(uhid)),
      device_(device),
      thread_([this](const std::stop_token& stop) { serve(stop); }) {}

// The thread goes on answering while the kernel takes the device away: it waits for answers.
UhidFace::~UhidFace() {
    uhid_event event{};
    event.type = UHID_DESTROY;
    write(event, sizeof event);
}

bool UhidFace::write(const uhid_event& event, std::size_t size) const {
    return ::write(uhid_.get(), &event, size) >= 0;
}

void UhidFace::serve(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        pollfd waited{.fd = uhid_.get(), .events = POLLIN, .revents = 0};
        if (::poll(&waited, 1, kWait_ms) <= 0) continue;
        uhid_event event{};
        if (::read(uhid_.get(), &event, sizeof event) <= 0) break;
        handle(event);
    }
    connected_ = false;
}

void UhidFace::handle(const uhid_event& event) {
    switch (event.type) {
        case UHID_OPEN:
            opened_ = true;
            break;
        case UHID_CLOSE:
            opened_ = false;
            break;
        case UHID_GET_REPORT:
            give_report(event);
            break;
        case UHID_SET_REPORT:
            take_report(event);
            break;
        default:
            break;
    }
}

void UhidFace::give_report(const uhid_event& asked) {
    uhid_event event{};
    event.type = UHID_GET_REPORT_REPLY;
    auto& reply = event.u.get_report_reply;
    reply.id = asked.u.get_report.id;
    const auto report = asked.u.get_report.rtype == UHID_FEATURE_REPORT
                            ? device_.control_get(asked.u.get_report.rnum, 0, kLargestReport)
                            : Result<std::vector<std::byte>>(Error{});
    if (report) {
        reply.size = static_cast<__u16>(report->size());
        std::memcpy(reply.data, report->data(), report->size());
    } else {
        reply.err = EIO;
    }
    write(event, sizeof event);
}

void UhidFace::take_report(const uhid_event& given) {
    const auto& set = given.u.set_report;
    const Bytes data = std::as_bytes(std::span(set.data)).first(set.size);
    uhid_event event{};
    event.type = UHID_SET_REPORT_REPLY;
    event.u.set_report_reply.id = set.id;
    const bool taken = set.rtype == UHID_FEATURE_REPORT && device_.control_set(set.rnum, 0, data);
    event.u.set_report_reply.err = taken ? 0 : EIO;
    write(event, sizeof event);
}

void UhidFace::send(std::vector<std::byte> packet) {
    if (!opened_) return;
    uhid_event event{};
    event.type = UHID_INPUT2;
    event.u.input2.size = static_cast<__u16>(packet.size());
    std::memcpy(event.u.input2.data, packet.data(), packet.size());
    // A whole event has 4 kB; the kernel takes what is there.
    write(event, offsetof(uhid_event, u.input2.data) + packet.size());
}

}  // namespace foverig::usb
