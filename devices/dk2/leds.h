#pragma once
// The infrared LEDs of one headset, as it describes them itself.
#include <cstdint>
#include <vector>

#include "devices/math.h"
#include "devices/transport.h"

namespace foverig::dk2 {

inline constexpr int kPatternFrames = 10;

/// In the inertial sensor's frame: x right, y up, z back, origin in the sensor.
struct Led {
    dvec3 position_m{0};
    dvec3 normal{0, 0, -1};  ///< unit length
    std::uint16_t code = 0;  ///< bit i: bright in frame i of the pattern
};

/// Reads reports 15 and 16 until their index comes again. Errors: what the transport says, and
/// invalid_data where indices are missing or no inertial sensor is among them.
Result<std::vector<Led>> read_leds(Transport& transport);

}  // namespace foverig::dk2
