#pragma once
// The camera's bridge, sensor and calibration memory behind the extension unit (DEVICES.md 1.8.1,
// 1.8.2, 1.8.4).
#include <map>

#include "devices/camera/lens.h"
#include "devices/camera/sensor_setup.h"

namespace foverig {

class CameraRegisters {
  public:
    explicit CameraRegisters(const camera::Lens& lens);

    /// SET_CUR: what GET_CUR of the same selector answers then.
    Status set(std::uint8_t selector, Bytes asked);
    Result<std::vector<std::byte>> get(std::uint8_t selector, std::size_t size) const;

    bool synchronised() const;
    /// From one frame's start to the earliest start of the next.
    Nanoseconds frame_time() const;
    Nanoseconds exposure() const;

  private:
    std::uint16_t sensor(std::uint8_t reg) const;
    void answer_i2c(Bytes asked);
    void answer_eeprom(Bytes asked);
    void answer_greeting(Bytes asked);

    std::vector<std::byte> memory_;
    std::map<std::pair<std::uint8_t, std::uint8_t>, std::uint16_t> chips_;  // by address, register
    std::map<std::uint8_t, std::vector<std::byte>> answers_;                // by selector
};

}  // namespace foverig
