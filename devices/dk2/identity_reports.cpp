#include "devices/dk2/identity_reports.h"

#include "devices/dk2/detail/report_check.h"

namespace foverig::dk2 {

using detail::blank;
using detail::reason_to_reject;

Result<ManufacturingReport> ManufacturingReport::decode(Bytes b) {
    if (auto reason = reason_to_reject<ManufacturingReport>(b)) return *reason;
    return ManufacturingReport{.command_id = read_u16(b, 1),
                               .stages = read_u8(b, 3),
                               .stage = read_u8(b, 4),
                               .stage_version = read_u8(b, 5),
                               .location = read_u16(b, 6),
                               .unix_time_s = read_u32(b, 8),
                               .result = read_u32(b, 12)};
}

std::array<std::byte, ManufacturingReport::kSize> ManufacturingReport::encode() const {
    auto b = blank(*this);
    write_u8(b, 3, stages);
    write_u8(b, 4, stage);
    write_u8(b, 5, stage_version);
    write_u16(b, 6, location);
    write_u32(b, 8, unix_time_s);
    write_u32(b, 12, result);
    return b;
}

Result<UuidReport> UuidReport::decode(Bytes b) {
    if (auto reason = reason_to_reject<UuidReport>(b)) return *reason;
    return UuidReport{.command_id = read_u16(b, 1), .uuid = detail::ascii_from(b, 3)};
}

std::array<std::byte, UuidReport::kSize> UuidReport::encode() const {
    auto b = blank(*this);
    detail::write_ascii(b, 3, uuid);
    return b;
}

}  // namespace foverig::dk2
