#pragma once
#include <cstdint>
#include <vector>

namespace foverig::usb {

inline constexpr std::uint8_t kCameraFrames = 2;  ///< the endpoint
inline constexpr std::uint32_t kCameraFrameBytes = 752 * 480;
inline constexpr std::uint32_t kCameraInterval = 166'667;  ///< 100 ns
inline constexpr std::uint32_t kCameraPayload = 16'384;    ///< of one transfer, header included
/// Selectors of the extension unit, and how long each is (DEVICES.md 1.8.1); 0: there is none.
std::uint16_t extension_size(std::uint8_t selector);

/// What belongs to the configuration of a UVC 1.0 camera of YUY2 376x480, which is how the DK2's
/// describes its 752x480 grey pixels. The real one streams isochronously; this one in bulk, and
/// its extension unit's GUID and terminals are ours, as no dump of the real ones was to be had.
std::vector<std::byte> camera_interfaces();

}  // namespace foverig::usb
