#include "devices/hardware/usb_node.h"

#include <fmt/format.h>
#include <libusb-1.0/libusb.h>

#include <array>
#include <functional>

#include "devices/hardware/holders.h"

namespace foverig::hardware {
namespace {

void for_each_device(libusb_context* context, const std::function<void(libusb_device*)>& visit) {
    libusb_device** devices = nullptr;
    const auto count = libusb_get_device_list(context, &devices);
    for (ssize_t i = 0; i < count; ++i) visit(devices[i]);
    if (count >= 0) libusb_free_device_list(devices, 1);
}

std::string serial_of(libusb_device_handle* handle, std::uint8_t index) {
    std::array<unsigned char, 64> text{};
    if (index == 0) return "";
    const int size = libusb_get_string_descriptor_ascii(handle, index, text.data(), text.size());
    return size > 0 ? std::string(text.begin(), text.begin() + size) : "";
}

/// Opens it for a moment.
FoundDevice look_at(libusb_device* device, std::uint8_t serial_index) {
    FoundDevice found{.path = node_of(device), .serial = "", .problem = {}};
    found.problem = opening_problem(found.path);
    if (found.problem) return found;
    libusb_device_handle* handle = nullptr;
    if (const int code = libusb_open(device, &handle); code != 0) {
        found.problem = claim_problem(found.path, code);
        return found;
    }
    found.serial = serial_of(handle, serial_index);
    if (const int code = libusb_claim_interface(handle, 0); code != 0) {
        found.problem = claim_problem(found.path, code);
    }
    libusb_close(handle);
    return found;
}

}  // namespace

std::string node_of(libusb_device* device) {
    return fmt::format("/dev/bus/usb/{:03}/{:03}", libusb_get_bus_number(device),
                       libusb_get_device_address(device));
}

libusb_device_handle* open_node(libusb_context* context, const std::string& path) {
    libusb_device_handle* handle = nullptr;
    for_each_device(context, [&](libusb_device* device) {
        if (handle == nullptr && node_of(device) == path && libusb_open(device, &handle) != 0) {
            handle = nullptr;
        }
    });
    return handle;
}

Error claim_problem(const std::string& path, int libusb_code) {
    switch (libusb_code) {
        case LIBUSB_ERROR_BUSY:
            return busy(path);
        case LIBUSB_ERROR_ACCESS:
            return forbidden(path);
        case LIBUSB_ERROR_NO_DEVICE:
            return {ErrorCode::closed, fmt::format("{} was unplugged just now", path)};
        default:
            return {ErrorCode::io,
                    fmt::format("{} cannot be opened: {}", path, libusb_strerror(libusb_code))};
    }
}

Error request_problem(const std::string& path, int request, int outcome) {
    if (outcome == LIBUSB_ERROR_PIPE) {
        return {ErrorCode::unsupported,
                fmt::format("{} refuses request {:#04x} (it stalls)", path, request)};
    }
    if (outcome == LIBUSB_ERROR_NO_DEVICE) {
        return {ErrorCode::closed, fmt::format("{} is unplugged", path)};
    }
    return {ErrorCode::io,
            fmt::format("{}: request {:#04x} failed: {}", path, request,
                        outcome < 0 ? libusb_strerror(outcome)
                                    : fmt::format("only {} bytes went over", outcome))};
}

std::vector<FoundDevice> find_gaze_trackers(const UsbId& id) {
    std::vector<FoundDevice> found;
    libusb_context* context = nullptr;
    if (libusb_init(&context) != 0) return found;
    for_each_device(context, [&](libusb_device* device) {
        libusb_device_descriptor about{};
        if (libusb_get_device_descriptor(device, &about) != 0) return;
        if (UsbId{about.idVendor, about.idProduct} == id) {
            found.push_back(look_at(device, about.iSerialNumber));
        }
    });
    libusb_exit(context);
    return found;
}

}  // namespace foverig::hardware
