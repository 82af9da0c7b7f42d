#include "devices/hardware/identity.h"

#include <fmt/format.h>

#include <charconv>

namespace foverig::hardware {
namespace {

std::optional<std::uint16_t> hex4(std::string_view text) {
    std::uint16_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
    if (text.size() != 4 || error != std::errc{} || end != text.data() + 4) return std::nullopt;
    return value;
}

}  // namespace

std::string text_of(const UsbId& id) {
    return fmt::format("{:04x}:{:04x}", id.vendor, id.product);
}

std::optional<UsbId> usb_id_of(std::string_view text) {
    if (text.size() != 9 || text[4] != ':') return std::nullopt;
    const auto vendor = hex4(text.substr(0, 4)), product = hex4(text.substr(5));
    if (!vendor || !product) return std::nullopt;
    return UsbId{*vendor, *product};
}

}  // namespace foverig::hardware
