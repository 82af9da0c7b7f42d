#pragma once
#include "renderer/kernels/depth_mesh.h"

namespace foverig {

/// One row of mesh cells: how squarely the last frame saw each (edge_t of Weier 2016 3.3), as the
/// cosine of the cell's geometric normal and the direction to the old eye. A cell that wrongly
/// closes the gap between two surfaces runs along the view: its cosine is near 0 however wide it is
/// drawn now. Inverse depth w is linear over a plane, and with its gradient g by tangents the
/// normal is (g, g.t - w), so a plane needs no points.
struct MeasureFacing {
    const float* depth_m;      ///< support G-buffer of the last frame
    const float* source_x_px;  ///< of a column, in the last image
    const float* source_y_px;
    vec2 tangent_per_px;
    vec2 corner_tangent;  ///< of image position (0, 0): right and down are positive
    int columns;
    float* facing;  ///< of the cell right of and below vertex [row * columns + column]

    RIG_HD void operator()(int row) const { span(row, 0, columns - 1); }

    /// Cells [begin, end) of the row.
    RIG_INLINE void span(int row, int begin, int end) const {
        const float* const above = depth_m + row * columns;
        const float* const below = above + columns;
        float* const out = facing + row * columns;
        const float* const source_x = source_x_px;
        const vec2 per_px = tangent_per_px;
        const vec2 corner = corner_tangent;
        const float y = 0.5F * (source_y_px[row] + source_y_px[row + 1]);
        const float tangent_y = corner.y + y * per_px.y;
        const float per_row = 1.0F / ((source_y_px[row + 1] - source_y_px[row]) * per_px.y);
#pragma GCC ivdep
        for (int i = begin; i < end; ++i) {
            const float w00 = 1.0F / above[i];
            const float w10 = 1.0F / above[i + 1];
            const float w01 = 1.0F / below[i];
            const float w11 = 1.0F / below[i + 1];
            const float per_column = 1.0F / ((source_x[i + 1] - source_x[i]) * per_px.x);
            const float tangent_x = corner.x + 0.5F * (source_x[i] + source_x[i + 1]) * per_px.x;
            // The steeper of the two edges of each axis, so that either triangle tells.
            const float gx = steeper(w10 - w00, w11 - w01) * per_column;
            const float gy = steeper(w01 - w00, w11 - w10) * per_row;
            const float w = 0.25F * (w00 + w10 + w01 + w11);
            const float gz = gx * tangent_x + gy * tangent_y - w;
            const float normal2 = gx * gx + gy * gy + gz * gz;
            const float view2 = 1.0F + tangent_x * tangent_x + tangent_y * tangent_y;
            out[i] = w / sqrtf(normal2 * view2);
        }
    }

    static RIG_HD float steeper(float a, float b) {
        return fabsf(a) > fabsf(b) ? a : b;
    }
};

}  // namespace foverig
