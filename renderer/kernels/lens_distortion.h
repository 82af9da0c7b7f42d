#pragma once
#include "renderer/math.h"
#include "renderer/vec.h"

namespace foverig {

/// One row of an eye's half of the panel: each colour of a pixel is fetched bilinearly from its own
/// place in the eye's image (DEVICES.md 2.1: three tangents a pixel), black where that place is
/// outside or NaN.
struct DistortRow {
    const float* source_px;  ///< planes x, y of red, then green, then blue; pixel centres at halves
    std::size_t plane;       ///< entries of one plane: all pixels of the half
    int width_px;            ///< of the half
    const vec3* eye;
    int eye_width_px;
    int eye_height_px;
    vec3* panel;  ///< the half's top left pixel
    int panel_stride_px;

    RIG_HD void operator()(int y) const {
        vec3* const out =
            panel + static_cast<std::size_t>(y) * static_cast<std::size_t>(panel_stride_px);
        draw<0>(y, out);
        draw<1>(y, out);
        draw<2>(y, out);
    }

    template <int kChannel>
    RIG_HD void draw(int y, vec3* out) const {
        const float* const source_x =
            source_px + 2 * kChannel * plane +
            static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px);
        const float* const source_y = source_x + plane;
        const float* const texels = &eye->x + kChannel;
        const int columns = eye_width_px;
        const auto width = static_cast<float>(eye_width_px);
        const auto height = static_cast<float>(eye_height_px);
        const int last_column = eye_width_px - 1;
        const int last_row = eye_height_px - 1;
        const int n = width_px;
#pragma GCC ivdep
        for (int x = 0; x < n; ++x) {
            const float at_x = source_x[x];
            const float at_y = source_y[x];
            const float fx = clamp_to(at_x - 0.5F, 0.0F, width - 1.0F);
            const float fy = clamp_to(at_y - 0.5F, 0.0F, height - 1.0F);
            const int x0 = static_cast<int>(fx);
            const int y0 = static_cast<int>(fy);
            const int x1 = x0 < last_column ? x0 + 1 : last_column;
            const int y1 = y0 < last_row ? y0 + 1 : last_row;
            const float u = fx - static_cast<float>(x0);
            const float v = fy - static_cast<float>(y0);
            const float a = texels[3 * (y0 * columns + x0)];
            const float b = texels[3 * (y0 * columns + x1)];
            const float c = texels[3 * (y1 * columns + x0)];
            const float d = texels[3 * (y1 * columns + x1)];
            const float top = a + u * (b - a);
            const float bottom = c + u * (d - c);
            (&out->x)[3 * x + kChannel] = top + v * (bottom - top);
        }
        // Apart, so that the loop above has no branch and gathers in vectors.
        for (int x = 0; x < n; ++x) {
            const bool inside = (source_x[x] >= 0.0F) & (source_x[x] <= width) &
                                (source_y[x] >= 0.0F) & (source_y[x] <= height);
            if (!inside) (&out->x)[3 * x + kChannel] = 0.0F;
        }
    }
};

}  // namespace foverig
