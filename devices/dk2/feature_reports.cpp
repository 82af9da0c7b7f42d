#include "devices/dk2/feature_reports.h"

#include "devices/dk2/detail/report_check.h"

namespace foverig::dk2 {

using detail::bit;
using detail::bit_if;
using detail::blank;
using detail::reason_to_reject;

Result<ConfigReport> ConfigReport::decode(Bytes b) {
    if (auto reason = reason_to_reject<ConfigReport>(b)) return *reason;
    const std::uint32_t flags = read_u8(b, 3);
    return ConfigReport{.command_id = read_u16(b, 1),
                        .raw = bit(flags, 0),
                        .calibration_test = bit(flags, 1),
                        .use_calibration = bit(flags, 2),
                        .auto_calibration = bit(flags, 3),
                        .motion_keep_alive = bit(flags, 4),
                        .command_keep_alive = bit(flags, 5),
                        .sensor_coordinates = bit(flags, 6),
                        .override_power = bit(flags, 7),
                        .interval = read_u8(b, 4),
                        .sample_rate_hz = read_u16(b, 5)};
}

std::array<std::byte, ConfigReport::kSize> ConfigReport::encode() const {
    auto b = blank(*this);
    const std::uint32_t flags = bit_if(raw, 0) | bit_if(calibration_test, 1) |
                                bit_if(use_calibration, 2) | bit_if(auto_calibration, 3) |
                                bit_if(motion_keep_alive, 4) | bit_if(command_keep_alive, 5) |
                                bit_if(sensor_coordinates, 6) | bit_if(override_power, 7);
    write_u8(b, 3, static_cast<std::uint8_t>(flags));
    write_u8(b, 4, interval);
    write_u16(b, 5, sample_rate_hz);
    return b;
}

Result<RangeReport> RangeReport::decode(Bytes b) {
    if (auto reason = reason_to_reject<RangeReport>(b)) return *reason;
    return RangeReport{.command_id = read_u16(b, 1),
                       .accel_g = read_u8(b, 3),
                       .gyro_deg_s = read_u16(b, 4),
                       .mag_milligauss = read_u16(b, 6)};
}

std::array<std::byte, RangeReport::kSize> RangeReport::encode() const {
    auto b = blank(*this);
    write_u8(b, 3, accel_g);
    write_u16(b, 4, gyro_deg_s);
    write_u16(b, 6, mag_milligauss);
    return b;
}

Result<RegisterReport> RegisterReport::decode(Bytes b) {
    if (auto reason = reason_to_reject<RegisterReport>(b)) return *reason;
    return RegisterReport{.command_id = read_u16(b, 1),
                          .chip = static_cast<Chip>(read_u8(b, 3)),
                          .address = read_u8(b, 4),
                          .payload = read_u8(b, 5)};
}

std::array<std::byte, RegisterReport::kSize> RegisterReport::encode() const {
    auto b = blank(*this);
    write_u8(b, 3, static_cast<std::uint8_t>(chip));
    write_u8(b, 4, address);
    write_u8(b, 5, payload);
    return b;
}

Result<Dk1KeepAliveReport> Dk1KeepAliveReport::decode(Bytes b) {
    if (auto reason = reason_to_reject<Dk1KeepAliveReport>(b)) return *reason;
    return Dk1KeepAliveReport{.command_id = read_u16(b, 1), .timeout_ms = read_u16(b, 3)};
}

std::array<std::byte, Dk1KeepAliveReport::kSize> Dk1KeepAliveReport::encode() const {
    auto b = blank(*this);
    write_u16(b, 3, timeout_ms);
    return b;
}

Result<DisplayInfoReport> DisplayInfoReport::decode(Bytes b) {
    if (auto reason = reason_to_reject<DisplayInfoReport>(b)) return *reason;
    DisplayInfoReport r{.command_id = read_u16(b, 1),
                        .distortion_type = read_u8(b, 3),
                        .width_px = read_u16(b, 4),
                        .height_px = read_u16(b, 6),
                        .width_um = read_u32(b, 8),
                        .height_um = read_u32(b, 12),
                        .center_v_um = read_u32(b, 16),
                        .lens_separation_um = read_u32(b, 20),
                        .lens_distance_left_um = read_u32(b, 24),
                        .lens_distance_right_um = read_u32(b, 28)};
    for (std::size_t i = 0; i < r.distortion_k.size(); ++i)
        r.distortion_k[i] = read_f32(b, 32 + 4 * i);
    return r;
}

std::array<std::byte, DisplayInfoReport::kSize> DisplayInfoReport::encode() const {
    auto b = blank(*this);
    write_u8(b, 3, distortion_type);
    write_u16(b, 4, width_px);
    write_u16(b, 6, height_px);
    write_u32(b, 8, width_um);
    write_u32(b, 12, height_um);
    write_u32(b, 16, center_v_um);
    write_u32(b, 20, lens_separation_um);
    write_u32(b, 24, lens_distance_left_um);
    write_u32(b, 28, lens_distance_right_um);
    for (std::size_t i = 0; i < distortion_k.size(); ++i) write_f32(b, 32 + 4 * i, distortion_k[i]);
    return b;
}

Result<SerialReport> SerialReport::decode(Bytes b) {
    if (auto reason = reason_to_reject<SerialReport>(b)) return *reason;
    return SerialReport{.command_id = read_u16(b, 1), .serial = detail::ascii_from(b, 3)};
}

std::array<std::byte, SerialReport::kSize> SerialReport::encode() const {
    auto b = blank(*this);
    detail::write_ascii(b, 3, serial);
    return b;
}

Result<TrackingReport> TrackingReport::decode(Bytes b) {
    if (auto reason = reason_to_reject<TrackingReport>(b)) return *reason;
    const std::uint32_t flags = read_u8(b, 4);
    return TrackingReport{.command_id = read_u16(b, 1),
                          .pattern = read_u8(b, 3),
                          .enable = bit(flags, 0),
                          .auto_increment = bit(flags, 1),
                          .use_carrier = bit(flags, 2),
                          .sync_input = bit(flags, 3),
                          .vsync_lock = bit(flags, 4),
                          .custom_pattern = bit(flags, 5),
                          .exposure_us = read_u16(b, 6),
                          .frame_interval_us = read_u16(b, 8),
                          .vsync_offset_us = read_u16(b, 10),
                          .duty = read_u8(b, 12)};
}

std::array<std::byte, TrackingReport::kSize> TrackingReport::encode() const {
    auto b = blank(*this);
    const std::uint32_t flags = bit_if(enable, 0) | bit_if(auto_increment, 1) |
                                bit_if(use_carrier, 2) | bit_if(sync_input, 3) |
                                bit_if(vsync_lock, 4) | bit_if(custom_pattern, 5);
    write_u8(b, 3, pattern);
    write_u8(b, 4, static_cast<std::uint8_t>(flags));
    write_u16(b, 6, exposure_us);
    write_u16(b, 8, frame_interval_us);
    write_u16(b, 10, vsync_offset_us);
    write_u8(b, 12, duty);
    return b;
}

Result<DisplayReport> DisplayReport::decode(Bytes b) {
    if (auto reason = reason_to_reject<DisplayReport>(b)) return *reason;
    const std::uint32_t bits = read_u32(b, 4);
    return DisplayReport{.command_id = read_u16(b, 1),
                         .brightness = read_u8(b, 3),
                         .shutter = static_cast<Shutter>(bits & 0xF),
                         .current_limit = static_cast<std::uint8_t>(bits >> 4 & 3),
                         .use_rolling = bit(bits, 6),
                         .reverse_rolling = bit(bits, 7),
                         .high_brightness = bit(bits, 8),
                         .self_refresh = bit(bits, 9),
                         .read_pixel = bit(bits, 10),
                         .direct_pentile = bit(bits, 11),
                         .persistence_rows = read_u16(b, 8),
                         .lighting_offset = read_u16(b, 10),
                         .pixel_settle_us = read_u16(b, 12),
                         .total_rows = read_u16(b, 14)};
}

std::array<std::byte, DisplayReport::kSize> DisplayReport::encode() const {
    auto b = blank(*this);
    const std::uint32_t bits =
        (static_cast<std::uint32_t>(shutter) & 0xF) | (std::uint32_t{current_limit} & 3) << 4 |
        bit_if(use_rolling, 6) | bit_if(reverse_rolling, 7) | bit_if(high_brightness, 8) |
        bit_if(self_refresh, 9) | bit_if(read_pixel, 10) | bit_if(direct_pentile, 11);
    write_u8(b, 3, brightness);
    write_u32(b, 4, bits);
    write_u16(b, 8, persistence_rows);
    write_u16(b, 10, lighting_offset);
    write_u16(b, 12, pixel_settle_us);
    write_u16(b, 14, total_rows);
    return b;
}

Result<KeepAliveMuxReport> KeepAliveMuxReport::decode(Bytes b) {
    if (auto reason = reason_to_reject<KeepAliveMuxReport>(b)) return *reason;
    return KeepAliveMuxReport{
        .command_id = read_u16(b, 1), .input_report = read_u8(b, 3), .timeout_ms = read_u16(b, 4)};
}

std::array<std::byte, KeepAliveMuxReport::kSize> KeepAliveMuxReport::encode() const {
    auto b = blank(*this);
    write_u8(b, 3, input_report);
    write_u16(b, 4, timeout_ms);
    return b;
}

}  // namespace foverig::dk2
