#pragma once
// The two input reports of the DK2 (DEVICES.md 1.2): 11, its own, and 1, the DK1's format.
// Raw units throughout; Dk2Decoder makes samples of them.
#include <array>
#include <cstdint>

#include "devices/bytes.h"
#include "devices/dk2/packed_triple.h"
#include "devices/result.h"

namespace foverig::dk2 {

constexpr int kMaxNumSamples = 254;

struct InertialSlot {
    Triple accel{};  ///< 1e-4 m/s^2, x right, y up, z back
    Triple gyro{};   ///< 1e-4 rad/s
    bool operator==(const InertialSlot&) const = default;
};

struct InputReport11 {
    static constexpr std::uint8_t kId = 11;
    static constexpr std::size_t kSize = 64;

    std::uint16_t last_command_id = 0;
    std::uint8_t num_samples = 1;  ///< 1..254; more than 2: slot 0 is the mean of all but the last
    std::uint16_t sample_count = 0;  ///< number of the first sample in this report
    std::int16_t temperature_centi_c = 0;
    std::uint32_t sample_timestamp_us = 0;  ///< of the newest sample
    std::array<InertialSlot, 2> slots{};
    std::array<std::int16_t, 3> mag_1e4_gauss{};
    std::uint16_t frame_count = 0;
    std::uint32_t frame_timestamp_us = 0;
    std::uint8_t frame_id = 0;  ///< colour read back from the panel
    std::uint8_t tracking_pattern = 0;
    std::uint16_t tracking_count = 0;
    std::uint32_t tracking_timestamp_us = 0;

    /// Exactly 64 bytes with id 11 and 1..254 samples, or invalid_data.
    static Result<InputReport11> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const InputReport11&) const = default;
};

/// No stamps, frames or exposures in this one.
struct InputReport1 {
    static constexpr std::uint8_t kId = 1;
    static constexpr std::size_t kSize = 62;

    std::uint8_t num_samples = 1;
    std::uint16_t sample_count = 0;
    std::uint16_t last_command_id = 0;
    std::int16_t temperature_centi_c = 0;
    std::array<InertialSlot, 3> slots{};
    std::array<std::int16_t, 3> mag_1e4_gauss{};

    /// At least 62 bytes (hidraw may pad to the endpoint's 64) with id 1 and 1..254 samples.
    static Result<InputReport1> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const InputReport1&) const = default;
};

}  // namespace foverig::dk2
