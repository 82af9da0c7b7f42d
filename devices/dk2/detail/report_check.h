#pragma once
// What every feature report's decoder asks first, and what several write alike.
#include <fmt/format.h>

#include <optional>
#include <string>

#include "devices/bytes.h"
#include "devices/result.h"

namespace foverig::dk2::detail {

/// The error where `b` is not a whole report `Report`; nothing where it is.
template <class Report>
std::optional<Error> reason_to_reject(Bytes b) {
    if (b.size() != Report::kSize) {
        return Error{ErrorCode::invalid_data,
                     fmt::format("DK2 feature report {} has {} bytes, expected {}", Report::kId,
                                 b.size(), Report::kSize)};
    }
    if (read_u8(b, 0) != Report::kId) {
        return Error{
            ErrorCode::invalid_data,
            fmt::format("DK2 feature report has id {}, expected {}", read_u8(b, 0), Report::kId)};
    }
    return std::nullopt;
}

/// A zeroed report with its id and command id in place.
template <class Report>
std::array<std::byte, Report::kSize> blank(const Report& report) {
    std::array<std::byte, Report::kSize> b{};
    write_u8(b, 0, Report::kId);
    write_u16(b, 1, report.command_id);
    return b;
}

/// The rest of `b` as text without its trailing NULs; what is not printable ASCII becomes '?'.
inline std::string ascii_from(Bytes b, std::size_t at) {
    std::string text;
    for (; at < b.size(); ++at) {
        const std::uint8_t c = read_u8(b, at);
        text += c == 0 || (c >= 0x20 && c < 0x7F) ? static_cast<char>(c) : '?';
    }
    text.erase(text.find_last_not_of('\0') + 1);
    return text;
}
/// Cut where `b` ends.
inline void write_ascii(std::span<std::byte> b, std::size_t at, const std::string& text) {
    for (std::size_t i = 0; i < text.size() && at + i < b.size(); ++i) {
        write_u8(b, at + i, static_cast<std::uint8_t>(text[i]));
    }
}

inline bool bit(std::uint32_t word, int index) {
    return (word >> index & 1u) != 0;
}
inline std::uint32_t bit_if(bool on, int index) {
    return on ? 1u << index : 0u;
}

}  // namespace foverig::dk2::detail
