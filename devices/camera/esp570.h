#pragma once
// The camera's bridge chip: its UVC extension unit as bytes, and over a transport (DEVICES.md
// 1.8.1). Each exchange is a SET_CUR and a GET_CUR of one selector; on the transport `id` is the
// selector and `value` the unit.
#include <array>
#include <cstdint>
#include <vector>

#include "devices/bytes.h"
#include "devices/transport.h"

namespace foverig::camera {

inline constexpr std::uint16_t kExtensionUnit = 4;
inline constexpr std::size_t kMostEepromBytes = 32;  ///< of one exchange

/// A register of a chip on the camera's I2C bus; addresses are 8-bit.
namespace i2c {

inline constexpr std::uint8_t kSelector = 2;
inline constexpr std::uint8_t kSensor = 0x98, kSyncController = 0x60;
using Buffer = std::array<std::byte, 6>;

Buffer encode_write(std::uint8_t address, std::uint8_t reg, std::uint16_t value);
Buffer encode_read(std::uint8_t address, std::uint8_t reg);
/// The answers; io where the chip did not answer.
Status decode_write(Bytes answer, Bytes asked);
Result<std::uint16_t> decode_read(Bytes answer);

}  // namespace i2c

namespace eeprom {

inline constexpr std::uint8_t kSelector = 5, kAddress = 0xA0;
inline constexpr std::uint16_t kVersion = 0x0FF0, kLensBlock = 0x2000, kSerial = 0x2800;
using Buffer = std::array<std::byte, 59>;

Buffer encode_read(std::uint16_t address, std::uint8_t size);
Result<std::vector<std::byte>> decode_read(Bytes answer, std::uint8_t size);

}  // namespace eeprom

/// All that the bridge is asked by; the answer of each depends on what was set before it.
std::vector<std::uint8_t> request_selectors();

class Esp570 {
  public:
    /// `transport` outlives this.
    explicit Esp570(Transport& transport) : transport_(&transport) {}

    Status write_register(std::uint8_t chip, std::uint8_t reg, std::uint16_t value);
    Result<std::uint16_t> read_register(std::uint8_t chip, std::uint8_t reg);
    Result<std::vector<std::byte>> read_eeprom(std::uint16_t address, std::size_t size);
    /// Two words that OUVRT sends when it opens the camera; their meaning is not known, nor whether
    /// they have 3 or 4 bytes: a transport over UVC sends as many as the camera takes.
    Status greet();

  private:
    Result<std::vector<std::byte>> exchange(std::uint8_t selector, Bytes asked);

    Transport* transport_;
};

}  // namespace foverig::camera
