#pragma once
// Rasterises mesh cells into one tile with a depth test (Weier 2016 3.2): for each pixel, where in the
// last frame its surface was. Rows go a vector at a time.
#include "renderer/kernels/cell_blocks.h"
#include "renderer/lanes.h"

namespace foverig {

inline constexpr int kRasterTile = 64;
/// One vector more than the tile: the last step of a row may touch what lies past it.
inline constexpr int kRasterStride = kRasterTile + 8;

/// Tile-local targets, kRasterStride floats a row. `inverse_depth` 0 means nothing was drawn.
struct RasterTile {
    float* inverse_depth = nullptr;
    float* source_x_w = nullptr;             ///< old image position times inverse depth
    float* source_y_w = nullptr;
    float* footprint_px = nullptr;           ///< width of the new pixel in the old image
};

struct RasterFrame {
    DepthMesh mesh;
    float scale_x = 1.0F;                    ///< target pixels per mesh pixel
    float scale_y = 1.0F;
    int x0 = 0;                              ///< of the tile in target pixels
    int y0 = 0;
    int width = kRasterTile;                 ///< clipped to the image
    int height = kRasterTile;
};

struct RasterVertex {
    float x;
    float y;
    float inverse_depth;
    float source_x;
    float source_y;
};

/// Edge a -> b as e(x, y) = slope_x x + slope_y y + offset, >= 0 on its left side on screen. Written from
/// the lower end whichever way it is asked for, so that two cells get exactly opposite values: no gap.
struct RasterEdge {
    float slope_x;
    float slope_y;
    float offset;

    RIG_HD RasterEdge(const RasterVertex& a, const RasterVertex& b) {
        const bool forward = a.y < b.y || (a.y == b.y && a.x < b.x);
        const float ax = forward ? a.x : b.x;
        const float ay = forward ? a.y : b.y;
        const float bx = forward ? b.x : a.x;
        const float by = forward ? b.y : a.y;
        const float sign = forward ? 1.0F : -1.0F;
        const float sx = ay - by;
        const float sy = bx - ax;
        const float k = -(sx * ax + sy * ay);
        slope_x = sign * sx;
        slope_y = sign * sy;
        offset = sign * k;
    }
};

/// A quantity linear over the target.
struct RasterPlane {
    float at_origin;
    float slope_x;
    float slope_y;

    RIG_HD RasterPlane(const RasterVertex& a, const RasterVertex& b, const RasterVertex& c, float fa, float fb, float fc, float inverse_area) {
        const float db = fb - fa;
        const float dc = fc - fa;
        slope_x = (db * (c.y - a.y) - dc * (b.y - a.y)) * inverse_area;
        slope_y = (dc * (b.x - a.x) - db * (c.x - a.x)) * inverse_area;
        at_origin = fa - slope_x * a.x - slope_y * a.y;
    }
};

RIG_INLINE void raster_triangle(const RasterTile& tile, int width, int height, RasterVertex a, RasterVertex b, RasterVertex c, float cell_px2) {
    float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (!(fabsf(area) > 1.0e-12F)) return;       // px^2: no pixel centre can lie in it
    if (area < 0.0F) {                            // seen from behind: still the surface that is there
        const RasterVertex t = b;
        b = c;
        c = t;
        area = -area;
    }
    const float left = min_of(min_of(a.x, b.x), c.x);
    const float right = max_of(max_of(a.x, b.x), c.x);
    const float top = min_of(min_of(a.y, b.y), c.y);
    const float bottom = max_of(max_of(a.y, b.y), c.y);
    const int x_begin = static_cast<int>(ceilf(max_of(left - 0.5F, 0.0F)));
    const int x_end = static_cast<int>(floorf(min_of(right + 0.5F, static_cast<float>(width))));
    const int y_begin = static_cast<int>(ceilf(max_of(top - 0.5F, 0.0F)));
    const int y_end = static_cast<int>(floorf(min_of(bottom + 0.5F, static_cast<float>(height))));
    if (x_begin >= x_end || y_begin >= y_end) return;
    const RasterEdge ab(a, b);
    const RasterEdge bc(b, c);
    const RasterEdge ca(c, a);
    const float inverse_area = 1.0F / area;
    const RasterPlane depth(a, b, c, a.inverse_depth, b.inverse_depth, c.inverse_depth, inverse_area);
    const RasterPlane source_x(a, b, c, a.source_x * a.inverse_depth, b.source_x * b.inverse_depth, c.source_x * c.inverse_depth, inverse_area);
    const RasterPlane source_y(a, b, c, a.source_y * a.inverse_depth, b.source_y * b.inverse_depth, c.source_y * c.inverse_depth, inverse_area);
    const float footprint = sqrtf(cell_px2 * inverse_area);
    for (int y = y_begin; y < y_end; ++y) {
        const float py = static_cast<float>(y) + 0.5F;
        const float ab_row = ab.slope_y * py + ab.offset;
        const float bc_row = bc.slope_y * py + bc.offset;
        const float ca_row = ca.slope_y * py + ca.offset;
        const float depth_row = depth.slope_y * py + depth.at_origin;
        const float source_x_row = source_x.slope_y * py + source_x.at_origin;
        const float source_y_row = source_y.slope_y * py + source_y.at_origin;
        for (int x = x_begin; x < x_end; x += kLanes) {
            const int at = y * kRasterStride + x;
            const Lanes px = lane_indices() + (static_cast<float>(x) + 0.5F);
            const Lanes inside = min_lanes(min_lanes(ab.slope_x * px + ab_row, bc.slope_x * px + bc_row), ca.slope_x * px + ca_row);
            const Lanes inverse_depth = depth.slope_x * px + depth_row;
            const Lanes nearest = load_lanes(tile.inverse_depth + at);
            const LaneMask drawn = (inside >= 0.0F) & (inverse_depth > nearest);
            store_lanes(tile.inverse_depth + at, select_lanes(drawn, inverse_depth, nearest));
            store_lanes(tile.source_x_w + at, select_lanes(drawn, source_x.slope_x * px + source_x_row, load_lanes(tile.source_x_w + at)));
            store_lanes(tile.source_y_w + at, select_lanes(drawn, source_y.slope_x * px + source_y_row, load_lanes(tile.source_y_w + at)));
            store_lanes(tile.footprint_px + at, select_lanes(drawn, footprint - Lanes{}, load_lanes(tile.footprint_px + at)));
        }
    }
}

/// Draws the cells of one block, in order, so that ties do not depend on threads.
RIG_INLINE void raster_block(const RasterFrame& frame, const RasterTile& tile, int row, int first_column) {
    const DepthMesh& m = frame.mesh;
    const int end = first_column + kBlockCells < m.columns - 1 ? first_column + kBlockCells : m.columns - 1;
    const auto vertex = [&](int line, int column) {
        const int i = line * m.columns + column;
        return RasterVertex{m.x_px[i] * frame.scale_x - static_cast<float>(frame.x0), m.y_px[i] * frame.scale_y - static_cast<float>(frame.y0),
                            m.inverse_depth[i], m.source_x_px[column], m.source_y_px[line]};
    };
    const auto right_of_all = static_cast<float>(frame.width);
    const auto below_all = static_cast<float>(frame.height);
    RasterVertex a = vertex(row, first_column);
    RasterVertex c = vertex(row + 1, first_column);
    for (int column = first_column; column < end; ++column) {
        const RasterVertex b = vertex(row, column + 1);
        const RasterVertex d = vertex(row + 1, column + 1);
        const bool seen = (a.inverse_depth > 0.0F) & (b.inverse_depth > 0.0F) & (c.inverse_depth > 0.0F) & (d.inverse_depth > 0.0F);
        const bool beside = (max_of(max_of(a.x, b.x), max_of(c.x, d.x)) < 0.0F) | (min_of(min_of(a.x, b.x), min_of(c.x, d.x)) > right_of_all) |
                            (max_of(max_of(a.y, b.y), max_of(c.y, d.y)) < 0.0F) | (min_of(min_of(a.y, b.y), min_of(c.y, d.y)) > below_all);
        if (seen & !beside) {
            const float cell_px2 = (b.source_x - a.source_x) * (c.source_y - a.source_y);
            raster_triangle(tile, frame.width, frame.height, a, b, d, cell_px2);
            raster_triangle(tile, frame.width, frame.height, a, d, c, cell_px2);
        }
        a = b;
        c = d;
    }
}

}  // namespace foverig
