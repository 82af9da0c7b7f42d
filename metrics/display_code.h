#pragma once
#include "metrics/plane.h"
#include "metrics/power.h"
#include "renderer/image.h"

namespace foverig::metrics {

/// The 8-bit sRGB code of a linear value, 0 to 255, clamped but not rounded; so images that were
/// never 8 bit lose nothing, and of those that were it is the code (within 1e-3).
inline float display_code(float linear) {
    const float x = std::min(std::max(linear, 0.0F), 1.0F);
    const float curve = 1.055F * power_of(x, 1.0F / 2.4F) - 0.055F;
    return 255.0F * (x <= 0.0031308F ? 12.92F * x : curve);
}

/// Throws std::invalid_argument where two images have no pixel-by-pixel comparison.
void check_same_size(const Image& a, const Image& b);

/// Luma (BT.601 weights) of the display codes, 0 to 255.
Plane luma_codes(const Image& image);

/// |a - b| of the display codes, mean of the channels, as share of full scale: 0 to 1.
Plane absolute_error(const Image& a, const Image& b);

}  // namespace foverig::metrics
