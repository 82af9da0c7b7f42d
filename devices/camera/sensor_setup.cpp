#include "devices/camera/sensor_setup.h"

#include <fmt/format.h>

namespace foverig::camera {
namespace {

using namespace mt9v034;

struct Setting {
    std::uint8_t reg;
    std::uint16_t value;
};

// A vertical blank above 9 makes a frame longer than a sixtieth: every second pulse would be
// missed.
constexpr std::array kSynchronised{
    Setting{kRegAutoExposure, 0},           Setting{kRegBlackControl, 1},
    Setting{kRegBlackValue, 0x81},          Setting{kRegAnalogGain, 16},
    Setting{kRegVerticalBlank, 5},          Setting{kRegHorizontalBlank, 94},
    Setting{kRegCoarseShutter, 11},         Setting{kRegFineShutter, 111},
    Setting{kRegChipControl, kMasterMode},  Setting{kRegLedOut, 2},
    Setting{kRegChipControl, kSnapshotMode}};
constexpr std::array kFreeRunning{
    Setting{kRegAnalogGain, 0x20},         Setting{kRegVerticalBlank, 57},
    Setting{kRegHorizontalBlank, 94},      Setting{kRegCoarseShutter, 0xF0},
    Setting{kRegChipControl, kMasterMode}, Setting{kRegLedOut, 0}};

// Start and length of the camera's own status light.
constexpr std::array kStatusLight{Setting{5, 1}, Setting{6, 0x20}};

Status write_all(Esp570& bridge, std::uint8_t chip, std::span<const Setting> settings) {
    for (const Setting& s : settings) {
        if (auto status = bridge.write_register(chip, s.reg, s.value); !status) return status;
    }
    return Done{};
}

}  // namespace

Status set_up_sensor(Esp570& bridge, Sync sync) {
    const auto version = bridge.read_register(i2c::kSensor, kRegChipVersion);
    if (!version) return version.error();
    if (*version != kChipVersion) {
        return Error{ErrorCode::unsupported,
                     fmt::format("the camera's sensor calls itself {:#06x}; expected {:#06x}",
                                 *version, kChipVersion)};
    }
    const auto mode = bridge.read_register(i2c::kSensor, kRegReadMode);
    if (!mode) return mode.error();
    const auto upright = static_cast<std::uint16_t>(*mode | kRowFlip | kColumnFlip);
    if (auto s = bridge.write_register(i2c::kSensor, kRegReadMode, upright); !s) return s;
    const auto settings = sync == Sync::headset ? std::span<const Setting>(kSynchronised)
                                                : std::span<const Setting>(kFreeRunning);
    if (auto s = write_all(bridge, i2c::kSensor, settings); !s) return s;
    return write_all(bridge, i2c::kSyncController, kStatusLight);
}

}  // namespace foverig::camera
