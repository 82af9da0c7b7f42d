#include "devices/dk2/led_reports.h"

#include "devices/dk2/detail/report_check.h"

namespace foverig::dk2 {

using detail::blank;
using detail::reason_to_reject;

Result<PositionReport> PositionReport::decode(Bytes b) {
    if (auto reason = reason_to_reject<PositionReport>(b)) return *reason;
    PositionReport r;
    r.command_id = read_u16(b, 1);
    r.version = read_u8(b, 3);
    for (std::size_t i = 0; i < 3; ++i) {
        r.position_um[i] = static_cast<std::int32_t>(read_u32(b, 4 + 4 * i));
        r.normal[i] = read_s16(b, 16 + 2 * i);
    }
    r.rotation_1e4_rad = read_s16(b, 22);
    r.index = read_u16(b, 24);
    r.count = read_u16(b, 26);
    r.kind = static_cast<Kind>(read_u16(b, 28));
    return r;
}

std::array<std::byte, PositionReport::kSize> PositionReport::encode() const {
    auto b = blank(*this);
    write_u8(b, 3, version);
    for (std::size_t i = 0; i < 3; ++i) {
        write_u32(b, 4 + 4 * i, static_cast<std::uint32_t>(position_um[i]));
        write_s16(b, 16 + 2 * i, normal[i]);
    }
    write_s16(b, 22, rotation_1e4_rad);
    write_u16(b, 24, index);
    write_u16(b, 26, count);
    write_u16(b, 28, static_cast<std::uint16_t>(kind));
    return b;
}

std::uint16_t PatternReport::code() const {
    std::uint16_t code = 0;
    for (int frame = 0; frame < 16; ++frame) {
        code = static_cast<std::uint16_t>(code | (sequence >> (2 * frame + 1) & 1u) << frame);
    }
    return code;
}

std::uint32_t PatternReport::sequence_of(std::uint16_t code, int length) {
    std::uint32_t sequence = 0;
    for (int frame = 0; frame < length; ++frame) {
        sequence |= ((code >> frame & 1u) != 0 ? 3u : 1u) << (2 * frame);
    }
    return sequence;
}

Result<PatternReport> PatternReport::decode(Bytes b) {
    if (auto reason = reason_to_reject<PatternReport>(b)) return *reason;
    return PatternReport{.command_id = read_u16(b, 1),
                         .length = read_u8(b, 3),
                         .sequence = read_u32(b, 4),
                         .index = read_u16(b, 8),
                         .count = read_u16(b, 10)};
}

std::array<std::byte, PatternReport::kSize> PatternReport::encode() const {
    auto b = blank(*this);
    write_u8(b, 3, length);
    write_u32(b, 4, sequence);
    write_u16(b, 8, index);
    write_u16(b, 10, count);
    return b;
}

}  // namespace foverig::dk2
