#include "simulators/camera/camera_registers.h"

#include <fmt/format.h>

#include <algorithm>

namespace foverig {
namespace {

using namespace camera::mt9v034;

constexpr std::size_t kMemorySize = 16384;  // 24AA128
constexpr double kPixelClock_hz = 26.66e6;
constexpr std::uint32_t kWidth_px = 752, kHeight_px = 480;
constexpr std::uint8_t kGreetingSelector = 3;
constexpr const char* kVersionText = "FOVERIG CAMERA 1";
constexpr const char* kSerialText = "FOVERIGSIMCAMERA0001";

void put(std::vector<std::byte>& memory, std::size_t at, Bytes bytes) {
    std::copy(bytes.begin(), bytes.end(), memory.begin() + static_cast<std::ptrdiff_t>(at));
}

}  // namespace

CameraRegisters::CameraRegisters(const camera::Lens& lens) : memory_(kMemorySize, std::byte{0xFF}) {
    put(memory_, camera::eeprom::kVersion, std::as_bytes(std::span(kVersionText, 16)));
    put(memory_, camera::eeprom::kLensBlock, camera::encode_lens_block(lens));
    put(memory_, camera::eeprom::kSerial, std::as_bytes(std::span(kSerialText, 20)));
    const auto preset = [this](std::uint8_t reg, std::uint16_t value) {
        chips_[{camera::i2c::kSensor, reg}] = value;
    };
    preset(kRegChipVersion, kChipVersion);
    preset(kRegHorizontalBlank, 94);
    preset(kRegVerticalBlank, 57);
    preset(kRegChipControl, kMasterMode);
    preset(kRegCoarseShutter, 0xF0);
}

std::uint16_t CameraRegisters::sensor(std::uint8_t reg) const {
    const auto found = chips_.find({camera::i2c::kSensor, reg});
    return found == chips_.end() ? std::uint16_t{0} : found->second;
}

bool CameraRegisters::synchronised() const {
    return sensor(kRegChipControl) == kSnapshotMode;
}

Nanoseconds CameraRegisters::frame_time() const {
    const double row_px = kWidth_px + sensor(kRegHorizontalBlank);
    const double clocks = row_px * (kHeight_px + sensor(kRegVerticalBlank)) + 4;
    return from_seconds(clocks / kPixelClock_hz);
}

Nanoseconds CameraRegisters::exposure() const {
    const double row_px = kWidth_px + sensor(kRegHorizontalBlank);
    return from_seconds((sensor(kRegCoarseShutter) * row_px + sensor(kRegFineShutter)) /
                        kPixelClock_hz);
}

Status CameraRegisters::set(std::uint8_t selector, Bytes asked) {
    if (selector == camera::i2c::kSelector && asked.size() == 6) {
        answer_i2c(asked);
    } else if (selector == camera::eeprom::kSelector && asked.size() == 59) {
        answer_eeprom(asked);
    } else if (selector == kGreetingSelector && (asked.size() == 3 || asked.size() == 4)) {
        answer_greeting(asked);
    } else {
        return Error{ErrorCode::unsupported,
                     fmt::format("the simulated camera has no selector {} of {} bytes", selector,
                                 asked.size())};
    }
    return Done{};
}

Result<std::vector<std::byte>> CameraRegisters::get(std::uint8_t selector, std::size_t size) const {
    const auto found = answers_.find(selector);
    if (found == answers_.end() || found->second.size() != size) {
        return Error{ErrorCode::unsupported,
                     fmt::format("the simulated camera answers nothing at selector {}", selector)};
    }
    return found->second;
}

void CameraRegisters::answer_i2c(Bytes asked) {
    auto answer = to_vector(asked);
    const std::pair key{read_u8(asked, 1), read_u8(asked, 2)};
    if (read_u8(asked, 0) == 0x84) {
        const auto found = chips_.find(key);
        const std::uint16_t value = found == chips_.end() ? std::uint16_t{0} : found->second;
        write_u8(answer, 1, static_cast<std::uint8_t>(value >> 8));
        write_u8(answer, 2, static_cast<std::uint8_t>(value & 0xFF));
    } else {
        chips_[key] = static_cast<std::uint16_t>(read_u8(asked, 3) << 8 | read_u8(asked, 4));
    }
    answers_[camera::i2c::kSelector] = std::move(answer);
}

void CameraRegisters::answer_eeprom(Bytes asked) {
    auto answer = to_vector(asked);
    const std::size_t from = std::size_t{read_u8(asked, 2)} << 8 | read_u8(asked, 3);
    const std::size_t size = std::min(camera::kMostEepromBytes, std::size_t{read_u8(asked, 4)});
    write_u8(answer, 1, static_cast<std::uint8_t>(size));
    for (std::size_t i = 0; i < size; ++i) answer[2 + i] = memory_[(from + i) % memory_.size()];
    answers_[camera::eeprom::kSelector] = std::move(answer);
}

void CameraRegisters::answer_greeting(Bytes asked) {
    auto answer = to_vector(asked);
    write_u8(answer, 1, read_u8(asked, 0) == 0x80 ? 0xDC : 0x98);
    answers_[kGreetingSelector] = std::move(answer);
}

}  // namespace foverig
