#pragma once
// The mesh rasterised over a whole frame at once (Weier 2016 3.2): cells in any order find the
// nearest surface of each pixel by an atomic maximum, then pixels ask it where it was. What results
// is what raster.h draws tile by tile.
#include <bit>

#include "renderer/kernels/frame_spans.h"

namespace foverig {

/// The nearest surface at a pixel: bits of its inverse depth above, its triangle below, inverted.
/// The largest key is the nearest surface, and of equally near ones the first that raster.h draws;
/// 0: none.
using RasterKey = unsigned long long;

/// `triangle` is twice its cell, plus one for the lower.
RIG_INLINE RasterKey raster_key(float inverse_depth, std::uint32_t triangle) {
    return (RasterKey{std::bit_cast<std::uint32_t>(inverse_depth)} << 32U) |
           (0xFFFFFFFFU - triangle);
}
RIG_INLINE float key_inverse_depth(RasterKey key) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(key >> 32U));
}
RIG_INLINE std::uint32_t key_triangle(RasterKey key) {
    return 0xFFFFFFFFU - static_cast<std::uint32_t>(key);
}

/// Targets of a frame. Keys of a tile lie together, 64 a row.
struct FrameRaster {
    RasterKey* keys = nullptr;
    int* large = nullptr;  ///< cells that one thread would draw for too long
    int* large_count = nullptr;
    TileGrid grid;
};

/// One tile's keys; no cell is large.
struct ClearRaster {
    FrameRaster raster;

    RIG_HD void operator()(int i) const {
        raster.keys[i] = 0;
        if (i == 0) *raster.large_count = 0;
    }
};

/// Draws one triangle into rows [y_first, y_end) of a tile's keys.
RIG_INLINE void raster_keys(RasterKey* keys, const TriangleLanes& t, int lane,
                            std::uint32_t triangle, int y_first, int y_end) {
    if constexpr (kLanes == 1) lane = 0;  // as the compiler cannot see
    const int begin = t.y_begin[lane] > y_first ? t.y_begin[lane] : y_first;
    const int end = t.y_end[lane] < y_end ? t.y_end[lane] : y_end;
    for (int y = begin; y < end; ++y) {
        const float py = static_cast<float>(y) + 0.5F;
        for (int x = t.x_begin[lane]; x < t.x_end[lane]; ++x) {
            const float px = static_cast<float>(x) + 0.5F;
            const auto edge = [&](int e) {
                return t.edge_x[e][lane] * px + (t.edge_y[e][lane] * py + t.edge_0[e][lane]);
            };
            if (!(min_of(min_of(edge(0), edge(1)), edge(2)) >= 0.0F)) continue;
            const float inverse_depth =
                t.plane_x[0][lane] * px + (t.plane_y[0][lane] * py + t.plane_0[0][lane]);
            if (inverse_depth > 0.0F)
                keep_largest(keys[y * kTile + x], raster_key(inverse_depth, triangle));
        }
    }
}

/// Pixels [x_begin, x_end) x [y_begin, y_end) that a cell may touch; empty if it is not drawn.
struct CellBox {
    int x_begin = 0;
    int x_end = 0;
    int y_begin = 0;
    int y_end = 0;

    RIG_HD bool empty() const { return x_begin >= x_end || y_begin >= y_end; }
    RIG_HD bool meets(const TileRect& rect) const {
        return x_begin < rect.x0 + rect.width && x_end > rect.x0 &&
               y_begin < rect.y0 + rect.height && y_end > rect.y0;
    }
};

/// Of the cell right of and below vertex (row, column). A pixel wider than need be: positions are
/// rounded again relative to a tile.
RIG_INLINE CellBox cell_box(const RasterFrame& frame, const TileGrid& grid, int row, int column) {
    const DepthMesh& m = frame.mesh;
    const int a = row * m.columns + column;
    const int corners[4] = {a, a + m.columns + 1, a + 1, a + m.columns};
    if (!(m.inverse_depth[corners[0]] > 0.0F && m.inverse_depth[corners[1]] > 0.0F)) return {};
    float left = 3.0e38F;
    float right = -3.0e38F;
    float top = 3.0e38F;
    float bottom = -3.0e38F;
    for (const int corner : corners) {  // both triangles have the first two
        if (!(m.inverse_depth[corner] > 0.0F)) continue;
        const float x = m.x_px[corner] * frame.scale_x;
        const float y = m.y_px[corner] * frame.scale_y;
        left = min_of(left, x);
        right = max_of(right, x);
        top = min_of(top, y);
        bottom = max_of(bottom, y);
    }
    const auto whole = [](float p, int add, int size_px) {
        return static_cast<int>(
            clamp_to(p + static_cast<float>(add), 0.0F, static_cast<float>(size_px)));
    };
    return {whole(left, -1, grid.width_px), whole(right, 2, grid.width_px),
            whole(top, -1, grid.height_px), whole(bottom, 2, grid.height_px)};
}

RIG_INLINE RasterFrame frame_of_tile(RasterFrame frame, const TileRect& rect) {
    frame.x0 = rect.x0;
    frame.y0 = rect.y0;
    frame.width = rect.width;
    frame.height = rect.height;
    return frame;
}

/// Cells larger than this go to RasterLargeCells, so that no thread draws for long.
inline constexpr int kLargeCell_px = 1024;

/// A vector of neighbouring cells: one on the device.
struct RasterCells {
    RasterFrame frame;  ///< its tile is not used
    FrameRaster to;

    static int count(const DepthMesh& m) { return (m.rows - 1) * spans_of(m.columns - 1); }

    RIG_HD void operator()(int i) const {
        const int cells_in_row = frame.mesh.columns - 1;
        const int row = i / spans_of(cells_in_row);
        const int column = i % spans_of(cells_in_row) * kLanes;
        const int lanes = cells_in_row - column < kLanes ? cells_in_row - column : kLanes;
        for (int lane = 0; lane < lanes; ++lane) {
            const int cell = row * frame.mesh.columns + column + lane;
            const CellBox box = cell_box(frame, to.grid, row, column + lane);
            if (box.empty()) continue;
            if ((box.x_end - box.x_begin) * (box.y_end - box.y_begin) > kLargeCell_px) {
                to.large[take_place(*to.large_count)] = cell;
                continue;
            }
            draw(box, row, column, lane, static_cast<std::uint32_t>(cell));
        }
    }

    RIG_INLINE void draw(const CellBox& box, int row, int column, int lane,
                         std::uint32_t cell) const {
        for (int y = box.y_begin / kTile; y * kTile < box.y_end; ++y) {
            for (int x = box.x_begin / kTile; x * kTile < box.x_end; ++x) {
                const int tile = y * to.grid.columns() + x;
                const CellLanes c =
                    set_up_cells(frame_of_tile(frame, to.grid.rect(tile)), row, column);
                RasterKey* const keys = to.keys + tile * kTilePixels;
                raster_keys(keys, c.upper, lane, 2 * cell, 0, kTile);
                raster_keys(keys, c.lower, lane, 2 * cell + 1, 0, kTile);
            }
        }
    }
};

/// One row of a tile: every large cell, as far as it reaches there.
struct RasterLargeCells {
    RasterFrame frame;
    FrameRaster to;

    static int count(const TileGrid& grid) { return grid.count() * kTile; }

    RIG_HD void operator()(int i) const {
        const int tile = i / kTile;
        TileRect rect = to.grid.rect(tile);
        const RasterFrame in_tile = frame_of_tile(frame, rect);
        const int y = i % kTile;
        if (y >= rect.height) return;
        rect.y0 += y;
        rect.height = 1;
        for (int k = 0; k < *to.large_count; ++k) {
            const int cell = to.large[k];
            const int row = cell / frame.mesh.columns;
            const int column = cell % frame.mesh.columns;
            if (!cell_box(frame, to.grid, row, column).meets(rect)) continue;
            const CellLanes c = set_up_cells(in_tile, row, column);
            RasterKey* const keys = to.keys + tile * kTilePixels;
            const auto triangle = static_cast<std::uint32_t>(2 * cell);
            raster_keys(keys, c.upper, 0, triangle, y, y + 1);
            raster_keys(keys, c.lower, 0, triangle + 1, y, y + 1);
        }
    }
};

/// From keys to what the passes after the raster read: the planes of the nearest triangle.
struct ResolveRaster {
    RasterFrame frame;
    const RasterKey* keys;
    RasterTile tile;
    TileGrid grid;

    static int count(const TileGrid& grid) { return grid.count() * kTilePixels; }

    RIG_HD void operator()(int i) const {
        const int in_tile = i % kTilePixels;
        const TileRect rect = grid.rect(i / kTilePixels);
        const int x = in_tile % kTile;
        const int y = in_tile / kTile;
        if (x >= rect.width || y >= rect.height) return;
        const int at = i / kTilePixels * kRasterTileFloats + y * kRasterStride + x;
        const RasterKey key = keys[i];
        tile.inverse_depth[at] = key_inverse_depth(key);
        if (key == 0) return;
        const auto cell = static_cast<int>(key_triangle(key) / 2);
        const CellCorners corners = cell_corners(
            frame_of_tile(frame, rect), cell / frame.mesh.columns, cell % frame.mesh.columns);
        const TriangleLanes t =
            corners.triangle(key_triangle(key) % 2 == 1, rect.width, rect.height);
        const float px = static_cast<float>(x) + 0.5F;
        const float py = static_cast<float>(y) + 0.5F;
        const auto plane = [&](int p) {
            return t.plane_x[p][0] * px + (t.plane_y[p][0] * py + t.plane_0[p][0]);
        };
        tile.source_x_w[at] = plane(1);
        tile.source_y_w[at] = plane(2);
        tile.magnification[at] = t.magnification[0];
    }
};

}  // namespace foverig
