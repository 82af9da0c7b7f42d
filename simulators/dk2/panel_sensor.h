#pragma once
// What the headset's electronics see of its panel: the seam between SimulatedDk2 and VirtualPanel.
#include <cstdint>
#include <optional>

#include "devices/time.h"

namespace foverig {

class PanelSensor {
  public:
    struct Reading {
        std::uint16_t frame_count = 0;  ///< number of the vsync that is described
        HostTime vsync{};
        std::optional<std::uint8_t> grey;  ///< corner pixel; none without read-pixel
    };

    virtual ~PanelSensor() = default;
    /// What the headset knows at `t`, or nothing before the first vsync. With `read_pixel` the
    /// answer is about the frame before (DEVICES.md 1.7).
    virtual std::optional<Reading> reading_at(HostTime t, bool read_pixel) const = 0;
};

}  // namespace foverig
