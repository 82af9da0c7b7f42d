#pragma once
// What the devices are known by on the bus (DEVICES.md 1.1, 4.5.1), and who may open them.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace foverig::hardware {

struct UsbId {
    std::uint16_t vendor = 0, product = 0;
    bool operator==(const UsbId&) const = default;
};

/// "2833:0021", as lsusb writes it; and back.
std::string text_of(const UsbId& id);
std::optional<UsbId> usb_id_of(std::string_view text);

inline constexpr UsbId kDk2{0x2833, 0x0021};
inline constexpr UsbId kDk2Camera{0x2833, 0x0201};
/// A test identifier of pid.codes, for private use; a scenario can name another.
inline constexpr UsbId kGazeTracker{0x1209, 0x0001};

inline constexpr const char* kUdevRuleFile = "devices/udev/70-foverig.rules";
inline constexpr const char* kInstallUdevRule =
    "sudo cp devices/udev/70-foverig.rules /etc/udev/rules.d/ && sudo udevadm control --reload && "
    "sudo udevadm trigger";

}  // namespace foverig::hardware
