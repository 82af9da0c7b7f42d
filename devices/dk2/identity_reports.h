#pragma once
// Feature reports that say which headset this is (DEVICES.md 1.5): 18 manufacturing, 19 UUID. The
// factory sets them; a SET of either writes to the device's memory for good, so that this rig only
// reads them.
#include <array>
#include <cstdint>
#include <string>

#include "devices/bytes.h"
#include "devices/result.h"

namespace foverig::dk2 {

/// 18 Manufacturing: how one stage of the production ended. The device steps to the next stage on
/// each GET.
struct ManufacturingReport {
    static constexpr std::uint8_t kId = 18;
    static constexpr std::size_t kSize = 16;  ///< the firmware's own table says 19 (1.1)
    static constexpr std::uint32_t kPassed = 1;

    std::uint16_t command_id = 0;
    std::uint8_t stages = 10;  ///< that the device has room for
    std::uint8_t stage = 0, stage_version = 0;
    std::uint16_t location = 0;     ///< line, station and machine
    std::uint32_t unix_time_s = 0;  ///< 0: the stage was never recorded
    std::uint32_t result = 0;       ///< 0 none, 1 passed, else an error of that stage

    static Result<ManufacturingReport> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const ManufacturingReport&) const = default;
};

/// 19 UUID: 20 ASCII characters, those of the USB serial; as SerialReport otherwise.
struct UuidReport {
    static constexpr std::uint8_t kId = 19;
    static constexpr std::size_t kSize = 23;  ///< the firmware's own table says 26 (1.1)

    std::uint16_t command_id = 0;
    std::string uuid{};

    static Result<UuidReport> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const UuidReport&) const = default;
};

}  // namespace foverig::dk2
