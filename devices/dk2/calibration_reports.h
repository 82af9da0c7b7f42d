#pragma once
// Feature reports that hold calibrations (DEVICES.md 1.5): 3 factory, 14 magnetometer,
// 20 temperature table, 21 gyro offset, 22 lens distortion. 3 needs two 64-byte control chunks.
#include <array>
#include <cstdint>

#include "devices/bytes.h"
#include "devices/dk2/packed_triple.h"
#include "devices/result.h"

namespace foverig::dk2 {

/// 3 Factory calibration. Matrix elements are value / (2^20 - 1), plus 1 on the diagonal.
struct FactoryCalibrationReport {
    static constexpr std::uint8_t kId = 3;
    static constexpr std::size_t kSize = 69;
    static constexpr double kMatrixUnit = 1.0 / 1048575.0;

    std::uint16_t command_id = 0;
    Triple accel_offset{};  ///< 1e-4 m/s^2
    Triple gyro_offset{};   ///< 1e-4 rad/s
    std::array<Triple, 3> accel_rows{};
    std::array<Triple, 3> gyro_rows{};
    std::int16_t temperature_centi_c = 0;

    static Result<FactoryCalibrationReport> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const FactoryCalibrationReport&) const = default;
};

/// 14 Magnetometer calibration: a fit of its readings to a sphere. The firmware stores it and never
/// applies it.
struct MagCalibrationReport {
    static constexpr std::uint8_t kId = 14;
    static constexpr std::size_t kSize = 52;

    std::uint16_t command_id = 0;
    std::uint8_t version = 0;                           ///< of the procedure; 0: none is stored
    std::array<std::array<std::int32_t, 4>, 3> rows{};  ///< 1e-4

    static Result<MagCalibrationReport> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const MagCalibrationReport&) const = default;
};

/// 20 Temperature table, one cell; the device steps to the next cell on each GET (35 in all).
struct TemperatureReport {
    static constexpr std::uint8_t kId = 20;
    static constexpr std::size_t kSize = 24;

    std::uint16_t command_id = 0;
    std::uint8_t version = 0;
    std::uint8_t bins = 7, bin = 0;
    std::uint8_t samples_per_bin = 5, sample = 0;
    std::int16_t target_centi_c = 0, actual_centi_c = 0;
    std::uint32_t unix_time_s = 0;
    Triple gyro_offset{};  ///< 1e-4 rad/s

    static Result<TemperatureReport> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const TemperatureReport&) const = default;
};

/// 21 Gyro offset found by the device's own auto-calibration.
struct GyroOffsetReport {
    static constexpr std::uint8_t kId = 21;
    static constexpr std::size_t kSize = 18;

    std::uint16_t command_id = 0;
    std::uint8_t version = 0;  ///< 0 none, 1 ended by motion, 2 full 6 s
    Triple offset{};           ///< 1e-4 rad/s
    std::uint32_t time_us = 0;
    std::int16_t temperature_centi_c = 0;

    static Result<GyroOffsetReport> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const GyroOffsetReport&) const = default;
};

/// 22 Lens distortion, one of two lenses' entries. Defaults are the firmware's.
struct LensDistortionReport {
    static constexpr std::uint8_t kId = 22;
    static constexpr std::size_t kSize = 64;

    std::uint16_t command_id = 0;
    std::uint8_t number = 2, index = 0, bit_mask = 0;
    std::uint16_t lens_type = 0;
    std::uint16_t version = 1;  ///< 1: Catmull-Rom-10
    std::uint16_t eye_relief_um = 17000;
    std::array<std::uint16_t, 11> k_q14{16433, 16712, 17072, 17465, 17924, 18448,
                                        19038, 19710, 20480, 21463, 22610};
    std::uint16_t max_r_q14 = 16384;
    std::uint16_t meters_per_tan_q19 = 18874;
    std::array<std::uint16_t, 4> chroma{24904, 22282, 45875, 43254};  ///< (v - 0x8000) / 2^19

    static Result<LensDistortionReport> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const LensDistortionReport&) const = default;
};

}  // namespace foverig::dk2
