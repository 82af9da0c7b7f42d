#include "devices/gaze/requests.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "devices/crc32.h"
#include "devices/gaze/detail/fields.h"

namespace foverig::gaze {
namespace {

using Out = std::span<std::byte>;

constexpr std::uint32_t kCalibrationMagic = 0x435A4753;  // "SGZC"

Error bad_payload(std::string_view name, std::string text) {
    return {ErrorCode::invalid_data, fmt::format("gaze {}: {}", name, text)};
}

std::optional<Error> wrong_size(std::string_view name, Bytes b, std::size_t size) {
    if (b.size() == size) return std::nullopt;
    return bad_payload(name, fmt::format("{} bytes, expected {}", b.size(), size));
}

std::optional<Error> wrong_size_or_crc(std::string_view name, Bytes b, std::size_t size) {
    if (auto reason = wrong_size(name, b, size)) return reason;
    if (read_u32(b, size - 4) == crc32(b.first(size - 4))) return std::nullopt;
    return bad_payload(name, "CRC does not match");
}

void finish(Out b) {
    write_u32(b, b.size() - 4, crc32(b.first(b.size() - 4)));
}

constexpr std::size_t kTextSize = 16;

std::string read_text(Bytes b, std::size_t at) {
    std::string text;
    for (std::size_t i = 0; i < kTextSize && read_u8(b, at + i) != 0; ++i) {
        const std::uint8_t c = read_u8(b, at + i);
        text += c >= 0x20 && c < 0x7F ? static_cast<char>(c) : '?';
    }
    return text;
}

void write_text(Out b, std::size_t at, const std::string& text) {
    for (std::size_t i = 0; i < kTextSize && i < text.size(); ++i) {
        write_u8(b, at + i, static_cast<std::uint8_t>(text[i]));
    }
}

}  // namespace

Result<Info> Info::decode(Bytes b) {
    if (auto reason = wrong_size_or_crc("GET_INFO", b, kSize)) return *reason;
    if (read_u32(b, 0) != detail::kMagic) return bad_payload("GET_INFO", "magic is not SGZ1");
    return Info{.major = read_u8(b, 4),
                .minor = read_u8(b, 5),
                .rates = read_u16(b, 6),
                .capabilities = read_u32(b, 8),
                .serial = read_text(b, 12),
                .firmware = read_text(b, 28),
                .display_width_px = read_u16(b, 44),
                .display_height_px = read_u16(b, 46),
                .clock_hz = read_u32(b, 48),
                .nominal_latency_us = read_u32(b, 52)};
}

std::array<std::byte, Info::kSize> Info::encode() const {
    std::array<std::byte, kSize> b{};
    write_u32(b, 0, detail::kMagic);
    write_u8(b, 4, major);
    write_u8(b, 5, minor);
    write_u16(b, 6, rates);
    write_u32(b, 8, capabilities);
    write_text(b, 12, serial);
    write_text(b, 28, firmware);
    write_u16(b, 44, display_width_px);
    write_u16(b, 46, display_height_px);
    write_u32(b, 48, clock_hz);
    write_u32(b, 52, nominal_latency_us);
    finish(b);
    return b;
}

Result<DeviceStatus> DeviceStatus::decode(Bytes b) {
    if (auto reason = wrong_size_or_crc("GET_STATUS", b, kSize)) return *reason;
    return DeviceStatus{.state = static_cast<DeviceState>(read_u8(b, 0)),
                        .last_error = read_u8(b, 1),
                        .rate_decihertz = read_u16(b, 2),
                        .session = read_u32(b, 4),
                        .sent = read_u32(b, 8),
                        .dropped = read_u32(b, 12),
                        .calibration_id = read_u16(b, 16),
                        .calibration_points = read_u8(b, 18),
                        .calibration_quality = read_u8(b, 19),
                        .mapping_mm = read_f32(b, 20),
                        .options = read_u32(b, 24)};
}

std::array<std::byte, DeviceStatus::kSize> DeviceStatus::encode() const {
    std::array<std::byte, kSize> b{};
    write_u8(b, 0, static_cast<std::uint8_t>(state));
    write_u8(b, 1, last_error);
    write_u16(b, 2, rate_decihertz);
    write_u32(b, 4, session);
    write_u32(b, 8, sent);
    write_u32(b, 12, dropped);
    write_u16(b, 16, calibration_id);
    write_u8(b, 18, calibration_points);
    write_u8(b, 19, calibration_quality);
    write_f32(b, 20, mapping_mm);
    write_u32(b, 24, options);
    finish(b);
    return b;
}

Result<DeviceTimeReply> DeviceTimeReply::decode(Bytes b) {
    if (auto reason = wrong_size_or_crc("GET_TIME", b, kSize)) return *reason;
    return DeviceTimeReply{.device_ns = read_u64(b, 0), .cookie = read_u16(b, 8)};
}

std::array<std::byte, DeviceTimeReply::kSize> DeviceTimeReply::encode() const {
    std::array<std::byte, kSize> b{};
    write_u64(b, 0, device_ns);
    write_u16(b, 8, cookie);
    finish(b);
    return b;
}

std::array<std::byte, 4> encode_options(std::uint32_t options) {
    std::array<std::byte, 4> b{};
    write_u32(b, 0, options);
    return b;
}

Result<std::uint32_t> decode_options(Bytes b) {
    if (auto reason = wrong_size("SET_OPTIONS", b, 4)) return *reason;
    return read_u32(b, 0);
}

std::array<std::byte, 4> encode_mapping(float distance_mm) {
    std::array<std::byte, 4> b{};
    write_f32(b, 0, distance_mm);
    return b;
}

Result<float> decode_mapping(Bytes b) {
    if (auto reason = wrong_size("SET_MAPPING", b, 4)) return *reason;
    const float distance_mm = read_f32(b, 0);
    if (!(distance_mm > 0)) return bad_payload("SET_MAPPING", "distance is not above 0 mm");
    return distance_mm;
}

Result<CalibrationBlob> CalibrationBlob::decode(Bytes b) {
    if (auto reason = wrong_size_or_crc("calibration", b, kSize)) return *reason;
    if (read_u32(b, 0) != kCalibrationMagic) {
        return bad_payload("calibration", "magic is not SGZC");
    }
    const std::size_t length = read_u16(b, 4);
    if (length > kMostData) {
        return bad_payload("calibration",
                           fmt::format("{} bytes of data, expected at most {}", length, kMostData));
    }
    return CalibrationBlob{.id = read_u16(b, 6), .data = to_vector(b.subspan(8, length))};
}

std::array<std::byte, CalibrationBlob::kSize> CalibrationBlob::encode() const {
    std::array<std::byte, kSize> b{};
    write_u32(b, 0, kCalibrationMagic);
    write_u16(b, 4, static_cast<std::uint16_t>(data.size()));
    write_u16(b, 6, id);
    std::copy(data.begin(), data.end(), b.begin() + 8);
    finish(b);
    return b;
}

std::vector<std::byte> encode_targets(std::span<const Vec2f> por_px) {
    std::vector<std::byte> b(8 * por_px.size());
    for (std::size_t i = 0; i < por_px.size(); ++i) detail::write_floats(b, 8 * i, por_px[i]);
    return b;
}

Result<std::vector<Vec2f>> decode_targets(Bytes b) {
    if (b.size() % 8 != 0)
        return bad_payload("targets", fmt::format("{} bytes, expected pairs", b.size()));
    std::vector<Vec2f> por_px(b.size() / 8);
    for (std::size_t i = 0; i < por_px.size(); ++i) por_px[i] = detail::read_floats<2>(b, 8 * i);
    return por_px;
}

Result<SimFault> SimFault::decode(Bytes b) {
    if (auto reason = wrong_size("SIM_FAULT", b, kSize)) return *reason;
    return SimFault{.kind = static_cast<FaultKind>(read_u16(b, 0)),
                    .count = read_u16(b, 2),
                    .p1 = read_f32(b, 4),
                    .p2 = read_f32(b, 8),
                    .duration_ms = read_u32(b, 12)};
}

std::array<std::byte, SimFault::kSize> SimFault::encode() const {
    std::array<std::byte, kSize> b{};
    write_u16(b, 0, static_cast<std::uint16_t>(kind));
    write_u16(b, 2, count);
    write_f32(b, 4, p1);
    write_f32(b, 8, p2);
    write_u32(b, 12, duration_ms);
    return b;
}

}  // namespace foverig::gaze
