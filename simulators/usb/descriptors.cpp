#include "simulators/usb/descriptors.h"

namespace foverig::usb {
namespace {

constexpr unsigned low(unsigned value) {
    return value & 0xFFU;
}
constexpr unsigned high(unsigned value) {
    return value >> 8U & 0xFFU;
}

}  // namespace

std::vector<std::byte> bytes_of(std::initializer_list<unsigned> values) {
    std::vector<std::byte> bytes;
    bytes.reserve(values.size());
    for (const unsigned value : values) bytes.push_back(static_cast<std::byte>(value));
    return bytes;
}

std::vector<std::byte> device_descriptor(const DeviceIdentity& id) {
    return bytes_of({18, kDeviceDescriptor, 0x00, 0x02, id.device_class[0], id.device_class[1],
                     id.device_class[2], 64, low(id.vendor), high(id.vendor), low(id.product),
                     high(id.product), low(id.release), high(id.release), 1, 2, 3, 1});
}

std::vector<std::byte> configuration_descriptor(const ConfigurationTraits& traits,
                                                const std::vector<std::byte>& rest) {
    constexpr std::size_t kSize = 9;
    const auto total = static_cast<unsigned>(kSize + rest.size());
    auto bytes = bytes_of({kSize, kConfigurationDescriptor, low(total), high(total),
                           traits.interfaces, 1, 0, traits.attributes, traits.current_ma / 2U});
    bytes.insert(bytes.end(), rest.begin(), rest.end());
    return bytes;
}

std::vector<std::byte> languages() {
    return bytes_of({4, kStringDescriptor, 0x09, 0x04});
}

std::vector<std::byte> string_descriptor(std::string_view ascii) {
    auto bytes = bytes_of({static_cast<unsigned>(2 + 2 * ascii.size()), kStringDescriptor});
    for (const char c : ascii) {
        bytes.push_back(static_cast<std::byte>(c));
        bytes.push_back(std::byte{0});
    }
    return bytes;
}

}  // namespace foverig::usb
