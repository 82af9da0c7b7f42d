#include "devices/display/edid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace foverig {
namespace {

constexpr std::size_t kBlock = 128;
constexpr std::array<std::uint8_t, 8> kHeader{0, 255, 255, 255, 255, 255, 255, 0};
constexpr std::size_t kDescriptors = 54, kDescriptorSize = 18;
constexpr std::uint8_t kNameTag = 0xFC;

/// Three letters of five bits, A is 1.
std::string maker_of(unsigned word) {
    std::string letters;
    for (const int shift : {10, 5, 0})
        letters += static_cast<char>('A' - 1 + ((word >> static_cast<unsigned>(shift)) & 31U));
    return letters;
}

std::string text_of(std::span<const std::byte> bytes) {
    std::string text;
    for (const std::byte b : bytes) {
        const char c = static_cast<char>(b);
        if (c == '\n') break;
        if (c >= ' ' && c <= '~') text += c;
    }
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

}  // namespace

Result<Edid> parse_edid(std::span<const std::byte> bytes) {
    const auto at = [&](std::size_t i) { return std::to_integer<std::uint8_t>(bytes[i]); };
    if (bytes.size() < kBlock)
        return Error{ErrorCode::invalid_data,
                     fmt::format("EDID of {} bytes; expected at least {}", bytes.size(), kBlock)};
    unsigned sum = 0;
    for (std::size_t i = 0; i < kBlock; ++i) sum += at(i);
    for (std::size_t i = 0; i < kHeader.size(); ++i)
        if (at(i) != kHeader[i])
            return Error{ErrorCode::invalid_data, "EDID: its first eight bytes are no header"};
    if (sum % 256 != 0)
        return Error{ErrorCode::invalid_data, "EDID: the checksum of its first block is wrong"};
    Edid edid{.maker = maker_of(at(8) * 256U + at(9)),
              .product = static_cast<std::uint16_t>(at(10) + at(11) * 256U),
              .name = {}};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto d = bytes.subspan(kDescriptors + i * kDescriptorSize, kDescriptorSize);
        const bool is_text = d[0] == std::byte{0} && d[1] == std::byte{0} && d[2] == std::byte{0};
        if (is_text && d[3] == std::byte{kNameTag}) edid.name = text_of(d.subspan(5));
    }
    return edid;
}

}  // namespace foverig
