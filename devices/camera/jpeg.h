#pragma once
#include "devices/camera/rgb_image.h"

namespace foverig::camera {

/// A JPEG into `image`, whose width and height it must have; there are bytes only for one that has.
/// One of a video may lack its Huffman tables, which are the standard's then (USB Video Class 1.1,
/// MJPEG payload). Errors: invalid_data.
Status decode_jpeg(Bytes jpeg, RgbImage& image);

}  // namespace foverig::camera
