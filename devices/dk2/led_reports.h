#pragma once
// Feature reports that describe the infrared LEDs (DEVICES.md 1.5, 1.8.5): 15 position, 16 blink
// pattern. The device steps to the next index on each GET. Frame of 15: x left, y up, z forward.
#include <array>
#include <cstdint>

#include "devices/bytes.h"
#include "devices/result.h"

namespace foverig::dk2 {

/// 15 Position of one LED, or of the inertial sensor.
struct PositionReport {
    static constexpr std::uint8_t kId = 15;
    static constexpr std::size_t kSize = 30;

    enum class Kind : std::uint16_t { led = 0, imu = 1 };

    std::uint16_t command_id = 0;
    std::uint8_t version = 1;  ///< 0 none, 1 default, 2 factory, 3 user
    std::array<std::int32_t, 3> position_um{};
    std::array<std::int16_t, 3> normal{};  ///< of no stated length
    std::int16_t rotation_1e4_rad = 0;
    std::uint16_t index = 0, count = 41;
    Kind kind = Kind::led;

    static Result<PositionReport> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const PositionReport&) const = default;
};

/// 16 Blink pattern of one LED: two bits a frame, the first lowest; 0 off, 1 dim, 3 bright.
struct PatternReport {
    static constexpr std::uint8_t kId = 16;
    static constexpr std::size_t kSize = 12;

    std::uint16_t command_id = 0;
    std::uint8_t length = 10;  ///< frames, up to 16
    std::uint32_t sequence = 0;
    std::uint16_t index = 0, count = 40;

    /// One bit a frame: bright or not.
    std::uint16_t code() const;
    static std::uint32_t sequence_of(std::uint16_t code, int length = 10);

    static Result<PatternReport> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const PatternReport&) const = default;
};

}  // namespace foverig::dk2
