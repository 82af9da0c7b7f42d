#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "simulators/usb/descriptors.h"

namespace foverig::usb {

inline constexpr std::uint8_t kCameraFrames = 2;  ///< the endpoint
inline constexpr std::uint32_t kCameraFrameBytes = 752 * 480;
inline constexpr std::uint32_t kCameraPayload = 16'384;  ///< of one transfer, header included
/// Selectors of the extension unit, and how long each is (DEVICES.md 1.8.1); 0: there is none.
std::uint16_t extension_size(std::uint8_t selector);

/// A UVC camera of one stream: YUY2 or Motion JPEG of one size at one rate.
struct CameraTraits {
    std::uint16_t vendor = 0, product = 0;
    std::array<std::string, 3> strings{};  ///< manufacturer, product, serial; ASCII
    std::uint16_t width_px = 0, height_px = 0;
    std::uint32_t interval = 0;   ///< 100 ns
    bool extension_unit = false;  ///< the DK2's bridge chip
    bool jpeg = false;            ///< frames of differing sizes

    /// Of a JPEG the most it may have.
    std::uint32_t frame_bytes() const { return 2U * width_px * height_px; }
};

/// YUY2 376x480, which is how the DK2's camera describes its 752x480 grey pixels.
CameraTraits dk2_camera();
/// A camera on the headset that sees the room (simulators/camera/room_camera.h); its identifier is
/// one for private use.
CameraTraits room_camera();

/// What belongs to the configuration of a UVC 1.0 camera. The real DK2's streams isochronously;
/// this one in bulk, and its extension unit's GUID and terminals are ours, as no dump of the real
/// ones was to be had.
std::vector<std::byte> camera_interfaces(const CameraTraits& camera);

}  // namespace foverig::usb
