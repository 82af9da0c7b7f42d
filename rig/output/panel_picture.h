#pragma once
#include "renderer/image.h"

namespace foverig {

/// What the DK2's panel shows of two eyes' images (landscape 1920x1080): each colour through its own
/// distortion (DEVICES.md 2.1), bilinear, black where the eye's image does not reach. An empty image
/// leaves its half black. For looking at; the frame's own pass is LensPass.
Image panel_picture(const Image& left, const Image& right);

}  // namespace foverig
