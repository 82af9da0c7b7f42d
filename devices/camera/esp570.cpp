#include "devices/camera/esp570.h"

#include <fmt/format.h>

#include <algorithm>

namespace foverig::camera {
namespace {

constexpr std::uint8_t kI2cWrite = 0x04, kI2cRead = 0x84, kEepromRead = 0x82;
constexpr std::uint8_t kGreetSelector = 3;
constexpr std::array<std::array<std::uint8_t, 4>, 2> kGreetings{
    {{0x80, 0x14, 0x00, 0x00}, {0xA0, 0xF0, 0x00, 0x00}}};
constexpr std::array<std::uint8_t, 2> kGreetingAnswers{0xDC, 0x98};

template <std::size_t N, std::size_t M>
std::array<std::byte, N> buffer_of(const std::array<std::uint8_t, M>& values) {
    std::array<std::byte, N> buffer{};
    for (std::size_t i = 0; i < std::min(N, M); ++i) buffer[i] = std::byte{values[i]};
    return buffer;
}

std::uint8_t high(std::uint16_t v) {
    return static_cast<std::uint8_t>(v >> 8);
}
std::uint8_t low(std::uint16_t v) {
    return static_cast<std::uint8_t>(v & 0xFF);
}

Error no_answer(const std::string& what) {
    return {ErrorCode::io, "the tracker camera's bridge did not answer: " + what};
}

}  // namespace

namespace i2c {

Buffer encode_write(std::uint8_t address, std::uint8_t reg, std::uint16_t value) {
    return buffer_of<6>(std::array{kI2cWrite, address, reg, high(value), low(value)});
}

Buffer encode_read(std::uint8_t address, std::uint8_t reg) {
    return buffer_of<6>(std::array{kI2cRead, address, reg});
}

Status decode_write(Bytes answer, Bytes asked) {
    if (answer.size() < Buffer{}.size() ||
        !std::equal(asked.begin(), asked.begin() + 3, answer.begin()) || read_u8(answer, 5) != 0) {
        return no_answer(fmt::format("register {:#04x} was not written", read_u8(asked, 2)));
    }
    return Done{};
}

Result<std::uint16_t> decode_read(Bytes answer) {
    if (answer.size() < Buffer{}.size() || read_u8(answer, 0) != kI2cRead ||
        read_u8(answer, 4) != 0 || read_u8(answer, 5) != 0) {
        return no_answer("a register was not read");
    }
    return static_cast<std::uint16_t>(read_u8(answer, 1) << 8 | read_u8(answer, 2));
}

}  // namespace i2c

namespace eeprom {

Buffer encode_read(std::uint16_t address, std::uint8_t size) {
    return buffer_of<59>(std::array{kEepromRead, kAddress, high(address), low(address), size});
}

Result<std::vector<std::byte>> decode_read(Bytes answer, std::uint8_t size) {
    if (answer.size() < 2u + size || read_u8(answer, 0) != kEepromRead ||
        read_u8(answer, 1) != size) {
        return no_answer("the calibration memory was not read");
    }
    return to_vector(answer.subspan(2, size));
}

}  // namespace eeprom

std::vector<std::uint8_t> request_selectors() {
    return {i2c::kSelector, kGreetSelector, eeprom::kSelector};
}

Result<std::vector<std::byte>> Esp570::exchange(std::uint8_t selector, Bytes asked) {
    if (auto status = transport_->control_set(selector, kExtensionUnit, asked); !status) {
        return status.error();
    }
    return transport_->control_get(selector, kExtensionUnit, asked.size());
}

Status Esp570::write_register(std::uint8_t chip, std::uint8_t reg, std::uint16_t value) {
    const auto asked = i2c::encode_write(chip, reg, value);
    const auto answer = exchange(i2c::kSelector, asked);
    if (!answer) return answer.error();
    return i2c::decode_write(*answer, asked);
}

Result<std::uint16_t> Esp570::read_register(std::uint8_t chip, std::uint8_t reg) {
    const auto answer = exchange(i2c::kSelector, i2c::encode_read(chip, reg));
    if (!answer) return answer.error();
    return i2c::decode_read(*answer);
}

Result<std::vector<std::byte>> Esp570::read_eeprom(std::uint16_t address, std::size_t size) {
    std::vector<std::byte> all;
    while (all.size() < size) {
        const auto part = static_cast<std::uint8_t>(std::min(kMostEepromBytes, size - all.size()));
        const auto from = static_cast<std::uint16_t>(address + all.size());
        const auto answer = exchange(eeprom::kSelector, eeprom::encode_read(from, part));
        if (!answer) return answer.error();
        const auto bytes = eeprom::decode_read(*answer, part);
        if (!bytes) return bytes.error();
        all.insert(all.end(), bytes->begin(), bytes->end());
    }
    return all;
}

Status Esp570::greet() {
    for (std::size_t i = 0; i < kGreetings.size(); ++i) {
        const auto answer = exchange(kGreetSelector, buffer_of<4>(kGreetings[i]));
        if (!answer) return answer.error();
        if (answer->size() < 2 || read_u8(*answer, 1) != kGreetingAnswers[i]) {
            return no_answer(fmt::format("word {} of its opening", i));
        }
    }
    return Done{};
}

}  // namespace foverig::camera
