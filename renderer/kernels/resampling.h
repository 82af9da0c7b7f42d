#pragma once
// Resampling info (Weier 2016 3.3): where a coarse reprojection of the last frame shows that the
// mesh or the sampling will fail. Found at the support resolution; a marked cell marks all pixels
// under it.
#include <cstdint>

#include "renderer/kernels/raster.h"
#include "renderer/kernels/reproject_pixels.h"
#include "renderer/kernels/support.h"

namespace foverig {

/// The coarse reprojection: `inverse_depth` 0 where the mesh does not reach.
struct CoarseView {
    float* inverse_depth = nullptr;
    float* luminance = nullptr;  ///< square root of luminance clamped to 1: near perceptual steps
    float* facing = nullptr;     ///< of the mesh there (see MeasureFacing)
    std::uint8_t* marked = nullptr;
    int columns = 0;
    int rows = 0;
};

/// One row of a coarse tile: depth, luminance and facing of the surface that the last frame saw
/// there.
struct ResolveCoarse {
    RasterTile tile;
    CoarseView coarse;
    const Half4* from_colour;
    int width_px;
    int height_px;
    const float* cell_facing;
    int cell_columns;  ///< of the mesh's vertices
    int cell_rows;
    float columns_per_px;
    float rows_per_px;
    int x0;
    int y0;
    int tile_width;

    RIG_HD void operator()(int y) const { span(y, 0, tile_width); }

    /// Pixels [begin, end) of the row.
    RIG_INLINE void span(int y, int begin, int end) const {
        for (int x = begin; x < end; ++x) {
            const int at = y * kRasterStride + x;
            const int target = (y0 + y) * coarse.columns + x0 + x;
            const float inverse_depth = tile.inverse_depth[at];
            coarse.inverse_depth[target] = inverse_depth;
            if (inverse_depth <= 0.0F) {
                coarse.luminance[target] = 0.0F;
                coarse.facing[target] = 1.0F;
                continue;
            }
            const float depth = 1.0F / inverse_depth;
            const float source_x =
                min_of(max_of(tile.source_x_w[at] * depth, 0.0F), static_cast<float>(width_px - 1));
            const float source_y = min_of(max_of(tile.source_y_w[at] * depth, 0.0F),
                                          static_cast<float>(height_px - 1));
            const vec4 colour = unpack_half4(
                from_colour[static_cast<int>(source_y) * width_px + static_cast<int>(source_x)]);
            coarse.luminance[target] = sqrtf(min_of(luminance(vec3(colour)), 1.0F));
            const int column = static_cast<int>(source_x * columns_per_px);
            const int row = static_cast<int>(source_y * rows_per_px);
            coarse.facing[target] =
                cell_facing[(row < cell_rows - 2 ? row : cell_rows - 2) * cell_columns +
                            (column < cell_columns - 2 ? column : cell_columns - 2)];
        }
    }
};

/// One row of the coarse view: marks depth steps, luminance steps and grazing surfaces. The paper's
/// edge_t = max{n.d, 0} < epsilon marks everything if d is the camera's viewing direction and n
/// faces it; d here points to the eye, so that edge_t is the cosine its text describes. n is the
/// reconstructed mesh's normal: the text is after "wrongly closed geometry".
struct MarkResampling {
    CoarseView coarse;
    float epsilon_depth;  ///< share of the nearer depth
    float epsilon_luminance;
    float epsilon_grazing;

    RIG_HD bool steps(int at, int neighbour) const {
        const float a = coarse.inverse_depth[at];
        const float b = coarse.inverse_depth[neighbour];
        // |d_a - d_b| > epsilon min(d_a, d_b) in inverse depths; an uncovered cell (0) is
        // infinitely far.
        const bool depth = fabsf(a - b) > epsilon_depth * min_of(a, b);
        return depth |
               (fabsf(coarse.luminance[at] - coarse.luminance[neighbour]) > epsilon_luminance);
    }

    RIG_HD void operator()(int row) const { span(row, 0, coarse.columns); }

    /// Columns [begin, end) of the row.
    RIG_INLINE void span(int row, int begin, int end) const {
        for (int column = begin; column < end; ++column) {
            const int at = row * coarse.columns + column;
            const bool left = column > 0 && steps(at, at - 1);
            const bool right = column + 1 < coarse.columns && steps(at, at + 1);
            const bool above = row > 0 && steps(at, at - coarse.columns);
            const bool below = row + 1 < coarse.rows && steps(at, at + coarse.columns);
            const bool grazing = coarse.inverse_depth[at] > 0.0F &&
                                 max_of(coarse.facing[at], 0.0F) < epsilon_grazing;
            coarse.marked[at] = static_cast<std::uint8_t>(left | right | above | below | grazing);
        }
    }
};

/// Which coarse cell a pixel lies in.
struct CoarseLookup {
    const std::uint8_t* marked = nullptr;     ///< null: nothing is marked (no history yet)
    const std::int16_t* column_of = nullptr;  ///< by pixel column
    const std::int16_t* row_of = nullptr;
    const std::int16_t* column_from_px = nullptr;  ///< first pixel column of each cell, and the end
    const std::int16_t* row_from_px = nullptr;
    int columns = 0;
    int rows = 0;

    RIG_HD int cell(int x, int y) const { return row_of[y] * columns + column_of[x]; }

    RIG_HD bool operator()(int x, int y) const {
        return marked != nullptr && marked[cell(x, y)] != 0;
    }

    /// Pixels from (x, y), whose cell is marked, to the nearest pixel on its row or column whose
    /// cell is not; 0: none within reach_px. Goes from cell to cell.
    RIG_HD int distance_to_unmarked(int x, int y, int reach_px) const {
        int nearest = reach_px + 1;
        const auto search = [&](const std::uint8_t* marks, int stride, const std::int16_t* from_px,
                                int cell, int cells, int p) {
            for (int c = cell - 1; c >= 0 && p - from_px[c + 1] + 1 < nearest; --c)
                if (marks[c * stride] == 0) nearest = p - from_px[c + 1] + 1;
            for (int c = cell + 1; c < cells && from_px[c] - p < nearest; ++c)
                if (marks[c * stride] == 0) nearest = from_px[c] - p;
        };
        const int column = column_of[x];
        const int row = row_of[y];
        search(marked + row * columns, 1, column_from_px, column, columns, x);
        search(marked + column, columns, row_from_px, row, rows, y);
        return nearest > reach_px ? 0 : nearest;
    }
};

}  // namespace foverig
