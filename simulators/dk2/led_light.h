#pragma once
// What the headset's LEDs do, and its sync pulse, which comes with each flash (DEVICES.md 1.8.3):
// the seam between SimulatedDk2 and SimulatedCamera.
#include <cstdint>
#include <optional>

#include "devices/time.h"

namespace foverig {

struct LedFlash {
    HostTime start{};
    Nanoseconds length{};
    std::uint8_t pattern = 0;  ///< frame of the blink pattern; 0xFF: all bright
};

class LedLight {
  public:
    virtual ~LedLight() = default;
    /// The first flash that starts after `t`, as the headset is set now; none while LEDs are off.
    virtual std::optional<LedFlash> flash_after(HostTime t) const = 0;
};

}  // namespace foverig
