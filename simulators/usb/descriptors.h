#pragma once
// Descriptors as bytes (USB 2.0, 9.6).
#include <array>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace foverig::usb {

inline constexpr std::uint8_t kDeviceDescriptor = 1, kConfigurationDescriptor = 2,
                              kStringDescriptor = 3;

std::vector<std::byte> bytes_of(std::initializer_list<unsigned> values);

struct DeviceIdentity {
    std::uint16_t vendor = 0, product = 0;
    std::uint16_t release = 0x0100;              ///< bcdDevice
    std::array<std::uint8_t, 3> device_class{};  ///< zeros: its interfaces say
};
/// USB 2.0, 64 bytes at endpoint 0, strings 1 to 3.
std::vector<std::byte> device_descriptor(const DeviceIdentity& identity);

struct ConfigurationTraits {
    std::uint8_t interfaces = 1;
    std::uint8_t attributes = 0x80;  ///< 0x20: wakes its host
    std::uint16_t current_ma = 100;
};
/// The header and what belongs to it.
std::vector<std::byte> configuration_descriptor(const ConfigurationTraits& traits,
                                                const std::vector<std::byte>& rest);

std::vector<std::byte> languages();  ///< string 0: U.S. English
std::vector<std::byte> string_descriptor(std::string_view ascii);

}  // namespace foverig::usb
