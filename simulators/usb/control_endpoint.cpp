#include "simulators/usb/control_endpoint.h"

#include "simulators/usb/descriptors.h"

namespace foverig::usb {
namespace {

constexpr std::uint8_t kToDevice = 0x00, kToInterface = 0x01, kToEndpoint = 0x02;  // recipients
constexpr std::uint8_t kIn = 0x80;

enum Request : std::uint8_t {
    kGetStatus = 0,
    kClearFeature = 1,
    kSetFeature = 3,
    kGetDescriptor = 6,
    kGetConfiguration = 8,
    kSetConfiguration = 9,
    kGetInterface = 10,
    kSetInterface = 11
};

}  // namespace

std::optional<std::vector<std::byte>> ControlEndpoint::descriptor(std::uint16_t value) const {
    const Descriptors& all = function_.descriptors();
    const auto index = static_cast<std::size_t>(value & 0xFFU);
    switch (value >> 8U) {
        case kDeviceDescriptor:
            return all.device;
        case kConfigurationDescriptor:
            return index == 0 ? std::optional(all.configuration) : std::nullopt;
        case kStringDescriptor:
            if (index == 0) return languages();
            if (index > all.strings.size()) return std::nullopt;
            return string_descriptor(all.strings.at(index - 1));
        default:
            return std::nullopt;
    }
}

std::optional<std::vector<std::byte>> ControlEndpoint::answer(const Setup& setup) {
    std::optional<std::vector<std::byte>> data;
    if (setup.type == (kIn | kToDevice) && setup.request == kGetDescriptor) {
        data = descriptor(setup.value);
    } else if (setup.type == (kIn | kToDevice) && setup.request == kGetConfiguration) {
        data = {static_cast<std::byte>(configuration_)};
    } else if ((setup.type & 0xFCU) == kIn && setup.request == kGetStatus) {
        data = {std::byte{0}, std::byte{0}};
    } else if (setup.type == (kIn | kToInterface) && setup.request == kGetInterface) {
        data = {std::byte{0}};
    } else {
        data = function_.answer(setup);
    }
    if (data && data->size() > setup.length) data->resize(setup.length);
    return data;
}

bool ControlEndpoint::take(const Setup& setup, Bytes data) {
    if (setup.type == kToDevice && setup.request == kSetConfiguration) {
        configuration_ = static_cast<std::uint8_t>(setup.value);
        return configuration_ <= 1;
    }
    // No interface of ours has a second setting, and no endpoint keeps a halt.
    if (setup.type == kToInterface && setup.request == kSetInterface) return setup.value == 0;
    if (setup.type == kToDevice || setup.type == kToEndpoint) {
        return setup.request == kClearFeature || setup.request == kSetFeature;
    }
    return function_.take(setup, data);
}

}  // namespace foverig::usb
