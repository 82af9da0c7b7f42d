#pragma once
// The support image and support G-buffer (Weier 2016 3.2-3.4): a coarse regular grid of pixels that
// every frame traces. Column i samples pixel x_i = round(i (W-1)/(n-1)), so that the corners are
// samples too.
#include "renderer/half.h"
#include "renderer/math.h"
#include "renderer/view.h"

namespace foverig {

struct SupportImages {
    Half4* colour = nullptr;
    Half4* light = nullptr;    ///< null without a light buffer
    float* depth_m = nullptr;  ///< along the view axis
    int columns = 0;
    int rows = 0;
};

/// Bilinear lookup between the four support samples around pixel (x, y).
struct SupportLookup {
    SupportImages support;
    float columns_per_px = 0.0F;  ///< (columns - 1) / (width - 1)
    float rows_per_px = 0.0F;

    RIG_HD vec4 operator()(const Half4* image, int x, int y) const {
        const float fx = static_cast<float>(x) * columns_per_px;
        const float fy = static_cast<float>(y) * rows_per_px;
        const int x0 =
            static_cast<int>(fx) < support.columns - 2 ? static_cast<int>(fx) : support.columns - 2;
        const int y0 =
            static_cast<int>(fy) < support.rows - 2 ? static_cast<int>(fy) : support.rows - 2;
        const float wx = min_of(fx - static_cast<float>(x0), 1.0F);
        const float wy = min_of(fy - static_cast<float>(y0), 1.0F);
        const Half4* p = image + y0 * support.columns + x0;
        const vec4 top = unpack_half4(p[0]) * (1.0F - wx) + unpack_half4(p[1]) * wx;
        const vec4 bottom = unpack_half4(p[support.columns]) * (1.0F - wx) +
                            unpack_half4(p[support.columns + 1]) * wx;
        return top * (1.0F - wy) + bottom * wy;
    }
};

}  // namespace foverig
