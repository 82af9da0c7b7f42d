#pragma once
// Feature reports that set and describe the DK2 (DEVICES.md 1.5). Byte 0 is the id, bytes 1-2 the
// host's CommandID, which the device echoes in LastCommandID of report 11 after a SET.
// `Transport::control_set/get` carry the whole report, id included. `decode` checks size and id.
#include <array>
#include <cstdint>
#include <string>

#include "devices/bytes.h"
#include "devices/result.h"

namespace foverig::dk2 {

/// 2 Config. Defaults are the power-on value 0x2C.
struct ConfigReport {
    static constexpr std::uint8_t kId = 2;
    static constexpr std::size_t kSize = 7;

    std::uint16_t command_id = 0;
    bool raw = false;
    bool calibration_test = false;
    bool use_calibration = true;  ///< the device applies report 3; off when the host does
    bool auto_calibration = true;
    bool motion_keep_alive = false;
    bool command_keep_alive = true;  ///< silence after the keep-alive time-out
    bool sensor_coordinates = false;
    bool override_power = false;
    std::uint8_t interval = 0;            ///< input reports at 1000 / (1 + interval) Hz
    std::uint16_t sample_rate_hz = 1000;  ///< read-only

    static Result<ConfigReport> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const ConfigReport&) const = default;
};

/// 4 Range.
struct RangeReport {
    static constexpr std::uint8_t kId = 4;
    static constexpr std::size_t kSize = 8;

    std::uint16_t command_id = 0;
    std::uint8_t accel_g = 4;             ///< 2, 4, 8, 16
    std::uint16_t gyro_deg_s = 2000;      ///< 250, 500, 1000, 2000
    std::uint16_t mag_milligauss = 4000;  ///< 4000, 8000, 12000, 16000

    static Result<RangeReport> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const RangeReport&) const = default;
};

/// 5 Register: a SET writes `payload` to a chip, at once and until it is unplugged. A GET says what
/// was written last and never what the chip holds, so that this rig only reads it.
struct RegisterReport {
    static constexpr std::uint8_t kId = 5;
    static constexpr std::size_t kSize = 6;

    enum class Chip : std::uint8_t { none = 0, mpu6500 = 3, lis3mdl = 4 };

    std::uint16_t command_id = 0;
    Chip chip = Chip::none;  ///< the field's 8 bits are kept; 1 and 2 are the DK1's
    std::uint8_t address = 0, payload = 0;

    static Result<RegisterReport> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const RegisterReport&) const = default;
};

/// 8 DK1 keep-alive. A SET also switches the input report to id 1, so only simulators decode it.
struct Dk1KeepAliveReport {
    static constexpr std::uint8_t kId = 8;
    static constexpr std::size_t kSize = 5;

    std::uint16_t command_id = 0;
    std::uint16_t timeout_ms = 10000;

    static Result<Dk1KeepAliveReport> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const Dk1KeepAliveReport&) const = default;
};

/// 9 Display info.
struct DisplayInfoReport {
    static constexpr std::uint8_t kId = 9;
    static constexpr std::size_t kSize = 56;

    std::uint16_t command_id = 0;
    std::uint8_t distortion_type = 1;  ///< bit 0 dimensions, bit 1 K
    std::uint16_t width_px = 1920, height_px = 1080;
    std::uint32_t width_um = 125760, height_um = 70740;
    std::uint32_t center_v_um = 35370;
    std::uint32_t lens_separation_um = 63500;
    std::uint32_t lens_distance_left_um = 39620, lens_distance_right_um = 39620;
    std::array<float, 6> distortion_k{};

    static Result<DisplayInfoReport> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const DisplayInfoReport&) const = default;
};

/// 10 Serial: 12 ASCII characters; bytes outside printable ASCII decode to '?'.
struct SerialReport {
    static constexpr std::uint8_t kId = 10;
    static constexpr std::size_t kSize = 15;

    std::uint16_t command_id = 0;
    std::string serial{};  ///< trailing NULs removed; encode pads or cuts to 12

    static Result<SerialReport> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const SerialReport&) const = default;
};

/// 12 Tracking: the infrared LEDs. Defaults are the firmware's.
struct TrackingReport {
    static constexpr std::uint8_t kId = 12;
    static constexpr std::size_t kSize = 13;

    std::uint16_t command_id = 0;
    std::uint8_t pattern = 0;  ///< 0xFF: all bright
    bool enable = false;
    bool auto_increment = true;
    bool use_carrier = true;
    bool sync_input = false;
    bool vsync_lock = false;
    bool custom_pattern = false;
    std::uint16_t exposure_us = 120;
    std::uint16_t frame_interval_us = 16667;
    std::uint16_t vsync_offset_us = 0;
    std::uint8_t duty = 128;  ///< 128 is 50 %

    static Result<TrackingReport> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const TrackingReport&) const = default;
};

/// 13 Display. The descriptor declares 14 bytes; the device answers 16 (DEVICES.md 1.1).
struct DisplayReport {
    static constexpr std::uint8_t kId = 13;
    static constexpr std::size_t kSize = 16;

    enum class Shutter : std::uint8_t { global = 0, top_to_bottom, left_to_right, right_to_left };

    std::uint16_t command_id = 0;
    std::uint8_t brightness = 255;
    Shutter shutter = Shutter::right_to_left;  ///< read-only; the field's 4 bits are kept
    std::uint8_t current_limit = 0;            ///< 2 bits
    bool use_rolling = true;
    bool reverse_rolling = true;
    bool high_brightness = false;
    bool self_refresh = false;
    bool read_pixel = false;  ///< latency tester on (1.7)
    bool direct_pentile = false;
    std::uint16_t persistence_rows = 435;
    std::uint16_t lighting_offset = 0;
    std::uint16_t pixel_settle_us = 100;  ///< read-only
    std::uint16_t total_rows = 1933;      ///< read-only

    static Result<DisplayReport> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const DisplayReport&) const = default;
};

/// 17 KeepAliveMux: keeps the device awake and selects the input report (DEVICES.md 1.6).
struct KeepAliveMuxReport {
    static constexpr std::uint8_t kId = 17;
    static constexpr std::size_t kSize = 6;

    std::uint16_t command_id = 0;
    std::uint8_t input_report = 11;
    std::uint16_t timeout_ms = 10000;

    static Result<KeepAliveMuxReport> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const KeepAliveMuxReport&) const = default;
};

}  // namespace foverig::dk2
