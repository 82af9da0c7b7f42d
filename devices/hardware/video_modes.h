#pragma once
// Formats, sizes and rates of a V4L2 camera, and which of them suits.
#include <vector>

#include "devices/hardware/video_calls.h"

namespace foverig::hardware {

/// What is asked of a camera; it may answer with another size.
struct VideoMode {
    std::uint32_t format = 0;  ///< fourcc
    std::uint32_t width_px = 0, height_px = 0, rate_hz = 60;

    bool operator==(const VideoMode&) const = default;
};

/// The tracker camera's: GREY where the kernel knows the DK2's quirk, else the YUYV of half the
/// width that the camera advertises.
std::vector<VideoMode> tracker_modes();

/// What somebody who wants a picture asks for.
struct VideoWish {
    std::uint32_t width_px = 640, height_px = 480, rate_hz = 30;
};

/// All that the camera offers of YUYV, MJPG and GREY; of sizes and rates without steps that which
/// is nearest to the wish. A camera that does not list rates is taken at its word for any.
std::vector<VideoMode> offered_modes(VideoCalls& calls, int file, const VideoWish& wish);

/// Best first: the nearest size, then the nearest rate (a lower one weighs more), then colour, then
/// without compression.
std::vector<VideoMode> nearest_first(std::vector<VideoMode> modes, const VideoWish& wish);

}  // namespace foverig::hardware
