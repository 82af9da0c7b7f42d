#include "devices/dk2/calibration_reports.h"

#include "devices/dk2/detail/report_check.h"

namespace foverig::dk2 {

using detail::blank;
using detail::reason_to_reject;

Result<FactoryCalibrationReport> FactoryCalibrationReport::decode(Bytes b) {
    if (auto reason = reason_to_reject<FactoryCalibrationReport>(b)) return *reason;
    FactoryCalibrationReport r;
    r.command_id = read_u16(b, 1);
    r.accel_offset = read_triple(b, 3);
    r.gyro_offset = read_triple(b, 11);
    for (std::size_t row = 0; row < 3; ++row) {
        r.accel_rows[row] = read_triple(b, 19 + kTripleSize * row);
        r.gyro_rows[row] = read_triple(b, 43 + kTripleSize * row);
    }
    r.temperature_centi_c = read_s16(b, 67);
    return r;
}

std::array<std::byte, FactoryCalibrationReport::kSize> FactoryCalibrationReport::encode() const {
    auto b = blank(*this);
    write_triple(b, 3, accel_offset);
    write_triple(b, 11, gyro_offset);
    for (std::size_t row = 0; row < 3; ++row) {
        write_triple(b, 19 + kTripleSize * row, accel_rows[row]);
        write_triple(b, 43 + kTripleSize * row, gyro_rows[row]);
    }
    write_s16(b, 67, temperature_centi_c);
    return b;
}

Result<MagCalibrationReport> MagCalibrationReport::decode(Bytes b) {
    if (auto reason = reason_to_reject<MagCalibrationReport>(b)) return *reason;
    MagCalibrationReport r;
    r.command_id = read_u16(b, 1);
    r.version = read_u8(b, 3);
    for (std::size_t i = 0; i < 12; ++i) {
        r.rows[i / 4][i % 4] = static_cast<std::int32_t>(read_u32(b, 4 + 4 * i));
    }
    return r;
}

std::array<std::byte, MagCalibrationReport::kSize> MagCalibrationReport::encode() const {
    auto b = blank(*this);
    write_u8(b, 3, version);
    for (std::size_t i = 0; i < 12; ++i) {
        write_u32(b, 4 + 4 * i, static_cast<std::uint32_t>(rows[i / 4][i % 4]));
    }
    return b;
}

Result<TemperatureReport> TemperatureReport::decode(Bytes b) {
    if (auto reason = reason_to_reject<TemperatureReport>(b)) return *reason;
    return TemperatureReport{.command_id = read_u16(b, 1),
                             .version = read_u8(b, 3),
                             .bins = read_u8(b, 4),
                             .bin = read_u8(b, 5),
                             .samples_per_bin = read_u8(b, 6),
                             .sample = read_u8(b, 7),
                             .target_centi_c = read_s16(b, 8),
                             .actual_centi_c = read_s16(b, 10),
                             .unix_time_s = read_u32(b, 12),
                             .gyro_offset = read_triple(b, 16)};
}

std::array<std::byte, TemperatureReport::kSize> TemperatureReport::encode() const {
    auto b = blank(*this);
    write_u8(b, 3, version);
    write_u8(b, 4, bins);
    write_u8(b, 5, bin);
    write_u8(b, 6, samples_per_bin);
    write_u8(b, 7, sample);
    write_s16(b, 8, target_centi_c);
    write_s16(b, 10, actual_centi_c);
    write_u32(b, 12, unix_time_s);
    write_triple(b, 16, gyro_offset);
    return b;
}

Result<GyroOffsetReport> GyroOffsetReport::decode(Bytes b) {
    if (auto reason = reason_to_reject<GyroOffsetReport>(b)) return *reason;
    return GyroOffsetReport{.command_id = read_u16(b, 1),
                            .version = read_u8(b, 3),
                            .offset = read_triple(b, 4),
                            .time_us = read_u32(b, 12),
                            .temperature_centi_c = read_s16(b, 16)};
}

std::array<std::byte, GyroOffsetReport::kSize> GyroOffsetReport::encode() const {
    auto b = blank(*this);
    write_u8(b, 3, version);
    write_triple(b, 4, offset);
    write_u32(b, 12, time_us);
    write_s16(b, 16, temperature_centi_c);
    return b;
}

Result<LensDistortionReport> LensDistortionReport::decode(Bytes b) {
    if (auto reason = reason_to_reject<LensDistortionReport>(b)) return *reason;
    LensDistortionReport r;
    r.command_id = read_u16(b, 1);
    r.number = read_u8(b, 3);
    r.index = read_u8(b, 4);
    r.bit_mask = read_u8(b, 5);
    r.lens_type = read_u16(b, 6);
    r.version = read_u16(b, 8);
    r.eye_relief_um = read_u16(b, 10);
    for (std::size_t i = 0; i < r.k_q14.size(); ++i) r.k_q14[i] = read_u16(b, 12 + 2 * i);
    r.max_r_q14 = read_u16(b, 34);
    r.meters_per_tan_q19 = read_u16(b, 36);
    for (std::size_t i = 0; i < r.chroma.size(); ++i) r.chroma[i] = read_u16(b, 38 + 2 * i);
    return r;
}

std::array<std::byte, LensDistortionReport::kSize> LensDistortionReport::encode() const {
    auto b = blank(*this);
    write_u8(b, 3, number);
    write_u8(b, 4, index);
    write_u8(b, 5, bit_mask);
    write_u16(b, 6, lens_type);
    write_u16(b, 8, version);
    write_u16(b, 10, eye_relief_um);
    for (std::size_t i = 0; i < k_q14.size(); ++i) write_u16(b, 12 + 2 * i, k_q14[i]);
    write_u16(b, 34, max_r_q14);
    write_u16(b, 36, meters_per_tan_q19);
    for (std::size_t i = 0; i < chroma.size(); ++i) write_u16(b, 38 + 2 * i, chroma[i]);
    return b;
}

}  // namespace foverig::dk2
