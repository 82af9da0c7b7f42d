#pragma once
// What the camera's sensor (MT9V034) and sync controller are told (DEVICES.md 1.8.2).
#include "devices/camera/esp570.h"

namespace foverig::camera {

enum class Sync {
    free_running,  ///< its own 58.7 frames a second
    headset        ///< one frame for each pulse of the headset
};

namespace mt9v034 {

inline constexpr std::uint16_t kChipVersion = 0x1324;
inline constexpr std::uint8_t kRegChipVersion = 0x00, kRegHorizontalBlank = 0x05,
                              kRegVerticalBlank = 0x06, kRegChipControl = 0x07,
                              kRegCoarseShutter = 0x0B, kRegReadMode = 0x0D, kRegLedOut = 0x1B,
                              kRegAnalogGain = 0x35, kRegBlackControl = 0x47, kRegBlackValue = 0x48,
                              kRegAutoExposure = 0xAF, kRegFineShutter = 0xD5;
inline constexpr std::uint16_t kMasterMode = 0x188, kSnapshotMode = 0x198;
inline constexpr std::uint16_t kRowFlip = 1 << 4, kColumnFlip = 1 << 5;

}  // namespace mt9v034

/// Checks that the sensor is the one we know, then sets it up. Errors: as the bridge's, and
/// unsupported for another sensor.
Status set_up_sensor(Esp570& bridge, Sync sync);

}  // namespace foverig::camera
