#pragma once
// A camera's frame in colour, as a display wants it.
#include <cstdint>
#include <vector>

#include "devices/camera/frame.h"

namespace foverig::camera {

/// Rows from the top without padding; red, green, blue, a byte each, encoded as sRGB.
struct RgbImage {
    int width_px = 0, height_px = 0;
    std::vector<std::uint8_t> bytes;
};

/// `header` is one that decode_any_header took of `packet`. YUYV is BT.601 of limited range (the
/// default of USB Video Class and of V4L2), two pixels sharing a colour; GREY has none. The image's
/// memory is used again. Errors: invalid_data, for a JPEG that is broken or of another size.
Status to_rgb(const FrameHeader& header, Bytes packet, RgbImage& image);

}  // namespace foverig::camera
