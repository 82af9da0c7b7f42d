#pragma once
// Rasterises mesh cells into one tile with a depth test (Weier 2016 3.2): for each pixel, where in
// the last frame its surface was. Rows go a vector at a time.
#include "renderer/kernels/cell_blocks.h"
#include "renderer/lanes.h"

namespace foverig {

inline constexpr int kRasterTile = 64;
/// One vector more than the tile: the last step of a row may touch what lies past it.
inline constexpr int kRasterStride = kRasterTile + 8;

/// Tile-local targets, kRasterStride floats a row. `inverse_depth` 0 means nothing was drawn.
struct RasterTile {
    float* inverse_depth = nullptr;
    float* source_x_w = nullptr;  ///< old image position times inverse depth
    float* source_y_w = nullptr;
    float* magnification = nullptr;  ///< area of the new pixel in the old image, px^2
};

struct RasterFrame {
    DepthMesh mesh;
    float scale_x = 1.0F;  ///< target pixels per mesh pixel
    float scale_y = 1.0F;
    int x0 = 0;  ///< of the tile in target pixels
    int y0 = 0;
    int width = kRasterTile;  ///< clipped to the image
    int height = kRasterTile;
};

/// Corners of kLanes neighbouring cells, in target pixels relative to the tile.
struct VertexLanes {
    Lanes x;
    Lanes y;
    Lanes inverse_depth;
    Lanes source_x;
    Lanes source_y;
};

/// Set-up of kLanes triangles, one in each lane of every array: e(x, y) = edge_x x + edge_y y +
/// edge_0 is >= 0 inside for all three edges; the planes give inverse depth and source position
/// times inverse depth.
struct TriangleLanes {
    alignas(32) float edge_x[3][kLanes];
    alignas(32) float edge_y[3][kLanes];
    alignas(32) float edge_0[3][kLanes];
    alignas(32) float plane_x[3][kLanes];
    alignas(32) float plane_y[3][kLanes];
    alignas(32) float plane_0[3][kLanes];
    alignas(32) float magnification[kLanes];  ///< old pixels per new pixel, by area
    alignas(32) int x_begin[kLanes];
    alignas(32) int x_end[kLanes];  ///< 0: not drawn
    alignas(32) int y_begin[kLanes];
    alignas(32) int y_end[kLanes];
};

/// Edge a -> b, written from its lower end whichever way it is asked for, so that the two triangles
/// that share it get exactly opposite values: no pixel falls between them.
RIG_INLINE void set_edge(TriangleLanes& t, int edge, const VertexLanes& a, const VertexLanes& b,
                         Lanes orientation) {
    const LaneMask forward = (a.y < b.y) | ((a.y == b.y) & (a.x < b.x));
    const Lanes ax = select_lanes(forward, a.x, b.x);
    const Lanes ay = select_lanes(forward, a.y, b.y);
    const Lanes bx = select_lanes(forward, b.x, a.x);
    const Lanes by = select_lanes(forward, b.y, a.y);
    const Lanes slope_x = ay - by;
    const Lanes slope_y = bx - ax;
    const Lanes offset = -(slope_x * ax + slope_y * ay);
    const Lanes sign = select_lanes(forward, orientation, -orientation);
    store_lanes(t.edge_x[edge], sign * slope_x);
    store_lanes(t.edge_y[edge], sign * slope_y);
    store_lanes(t.edge_0[edge], sign * offset);
}

RIG_INLINE void set_plane(TriangleLanes& t, int plane, const VertexLanes& a, const VertexLanes& b,
                          const VertexLanes& c, Lanes fa, Lanes fb, Lanes fc, Lanes inverse_area) {
    const Lanes db = fb - fa;
    const Lanes dc = fc - fa;
    const Lanes slope_x = (db * (c.y - a.y) - dc * (b.y - a.y)) * inverse_area;
    const Lanes slope_y = (dc * (b.x - a.x) - db * (c.x - a.x)) * inverse_area;
    store_lanes(t.plane_x[plane], slope_x);
    store_lanes(t.plane_y[plane], slope_y);
    store_lanes(t.plane_0[plane], fa - slope_x * a.x - slope_y * a.y);
}

/// Twice the area below which no pixel centre can lie inside, in px^2.
inline constexpr float kSmallestArea_px2 = 1.0e-12F;

RIG_INLINE TriangleLanes set_up_triangles(const VertexLanes& a, const VertexLanes& b,
                                          const VertexLanes& c, Lanes cell_px2, int width,
                                          int height) {
    TriangleLanes t;
    const Lanes zero{};
    const Lanes one = zero + 1.0F;
    const Lanes area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    // Seen from behind it is still the surface that is there: the edges are turned round.
    const Lanes orientation = select_lanes(area < zero, -one, one);
    const LaneMask drawn = (area * orientation > zero + kSmallestArea_px2) &
                           (a.inverse_depth > zero) & (b.inverse_depth > zero) &
                           (c.inverse_depth > zero);
    const Lanes inverse_area = one / select_lanes(drawn, area, one);
    set_edge(t, 0, a, b, orientation);
    set_edge(t, 1, b, c, orientation);
    set_edge(t, 2, c, a, orientation);
    set_plane(t, 0, a, b, c, a.inverse_depth, b.inverse_depth, c.inverse_depth, inverse_area);
    set_plane(t, 1, a, b, c, a.source_x * a.inverse_depth, b.source_x * b.inverse_depth,
              c.source_x * c.inverse_depth, inverse_area);
    set_plane(t, 2, a, b, c, a.source_y * a.inverse_depth, b.source_y * b.inverse_depth,
              c.source_y * c.inverse_depth, inverse_area);
    store_lanes(t.magnification, cell_px2 * inverse_area * orientation);
    const Lanes left = min_lanes(min_lanes(a.x, b.x), c.x);
    const Lanes right = max_lanes(max_lanes(a.x, b.x), c.x);
    const Lanes top = min_lanes(min_lanes(a.y, b.y), c.y);
    const Lanes bottom = max_lanes(max_lanes(a.y, b.y), c.y);
    const Lanes last_x = zero + static_cast<float>(width);
    const Lanes last_y = zero + static_cast<float>(height);
    store_lanes(t.x_begin, ceil_lanes(min_lanes(max_lanes(left - 0.5F, zero), last_x)));
    store_lanes(t.y_begin, ceil_lanes(min_lanes(max_lanes(top - 0.5F, zero), last_y)));
    store_lanes(t.x_end, truncate_lanes(select_lanes(
                             drawn, max_lanes(min_lanes(right + 0.5F, last_x), zero), zero)));
    store_lanes(t.y_end, truncate_lanes(max_lanes(min_lanes(bottom + 0.5F, last_y), zero)));
    return t;
}

RIG_INLINE void raster_triangle(const RasterTile& tile, const TriangleLanes& t, int lane) {
    const int x_end = t.x_end[lane];
    const Lanes zero{};
    for (int y = t.y_begin[lane]; y < t.y_end[lane]; ++y) {
        const float py = static_cast<float>(y) + 0.5F;
        for (int x = t.x_begin[lane]; x < x_end; x += kLanes) {
            const int at = y * kRasterStride + x;
            const Lanes px = lane_indices() + (static_cast<float>(x) + 0.5F);
            const auto edge = [&](int e) {
                return t.edge_x[e][lane] * px + (t.edge_y[e][lane] * py + t.edge_0[e][lane]);
            };
            const auto plane = [&](int p) {
                return t.plane_x[p][lane] * px + (t.plane_y[p][lane] * py + t.plane_0[p][lane]);
            };
            const Lanes inside = min_lanes(min_lanes(edge(0), edge(1)), edge(2));
            const Lanes inverse_depth = plane(0);
            const Lanes nearest = load_lanes(tile.inverse_depth + at);
            const LaneMask drawn = (inside >= zero) & (inverse_depth > nearest);
            store_lanes(tile.inverse_depth + at, select_lanes(drawn, inverse_depth, nearest));
            store_lanes(tile.source_x_w + at,
                        select_lanes(drawn, plane(1), load_lanes(tile.source_x_w + at)));
            store_lanes(tile.source_y_w + at,
                        select_lanes(drawn, plane(2), load_lanes(tile.source_y_w + at)));
            store_lanes(tile.magnification + at, select_lanes(drawn, zero + t.magnification[lane],
                                                              load_lanes(tile.magnification + at)));
        }
    }
}

/// Corners of kLanes neighbouring cells: a and b above, c and d below.
struct CellCorners {
    VertexLanes a;
    VertexLanes b;
    VertexLanes c;
    VertexLanes d;

    RIG_INLINE TriangleLanes triangle(bool lower, int width, int height) const {
        const Lanes cell_px2 = (b.source_x - a.source_x) * (c.source_y - a.source_y);
        return lower ? set_up_triangles(a, d, c, cell_px2, width, height)
                     : set_up_triangles(a, b, d, cell_px2, width, height);
    }
};

/// Of the cells right of and below vertices (row, column) and on. Vertex arrays have room for one
/// vector past their end.
RIG_INLINE CellCorners cell_corners(const RasterFrame& frame, int row, int column) {
    const DepthMesh& m = frame.mesh;
    const Lanes zero{};
    const auto vertices = [&](int line, int first) {
        const int i = line * m.columns + first;
        return VertexLanes{load_lanes(m.x_px + i) * frame.scale_x - static_cast<float>(frame.x0),
                           load_lanes(m.y_px + i) * frame.scale_y - static_cast<float>(frame.y0),
                           load_lanes(m.inverse_depth + i), load_lanes(m.source_x_px + first),
                           zero + m.source_y_px[line]};
    };
    return {vertices(row, column), vertices(row, column + 1), vertices(row + 1, column),
            vertices(row + 1, column + 1)};
}

/// The two triangles of kLanes neighbouring cells.
struct CellLanes {
    TriangleLanes upper;
    TriangleLanes lower;
};

RIG_INLINE CellLanes set_up_cells(const RasterFrame& frame, int row, int column) {
    const CellCorners corners = cell_corners(frame, row, column);
    return {corners.triangle(false, frame.width, frame.height),
            corners.triangle(true, frame.width, frame.height)};
}

/// Draws the cells of one block, in order, so that ties do not depend on threads.
RIG_INLINE void raster_block(const RasterFrame& frame, const RasterTile& tile, int row,
                             int first_column) {
    const int cells_in_row = frame.mesh.columns - 1;
    const int end =
        first_column + kBlockCells < cells_in_row ? first_column + kBlockCells : cells_in_row;
    for (int column = first_column; column < end; column += kLanes) {
        const CellLanes cell = set_up_cells(frame, row, column);
        const int cells = end - column < kLanes ? end - column : kLanes;
        for (int lane = 0; lane < cells; ++lane) {
            raster_triangle(tile, cell.upper, lane);
            raster_triangle(tile, cell.lower, lane);
        }
    }
}

}  // namespace foverig
