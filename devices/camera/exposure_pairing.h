#pragma once
// Which flash of the LEDs a frame shows (DEVICES.md 1.8.3). The headset tells of flashes within a
// millisecond or two; a frame comes after it was read out, 16 ms later.
#include <deque>
#include <optional>

#include "devices/dk2/decoder.h"

namespace foverig::camera {

struct PairedExposure {
    int number = 0;  ///< counts on where the device's 16 bits wrap
    std::uint8_t pattern = 0;
    HostTime middle{};
    Dk2Time middle_device{};
};

class ExposurePairing {
  public:
    /// `flash` is how long the LEDs are lit.
    explicit ExposurePairing(Nanoseconds flash) : half_flash_(flash / 2) {}

    /// In order.
    void add(const dk2::LedExposure& exposure);
    /// The flash that a frame stamped so shows: the last that began before the frame's first packet
    /// came, unless that is more than a frame ago. Each flash is given once.
    std::optional<PairedExposure> of(HostTime frame_stamp);

  private:
    Nanoseconds half_flash_;
    bool counting_ = false;
    int number_ = 0;
    std::uint16_t last_count_ = 0;
    std::deque<PairedExposure> exposures_;
};

}  // namespace foverig::camera
