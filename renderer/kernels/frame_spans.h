#pragma once
// Kernels of rows and tiles, cut into pieces of one vector: a pixel a thread on the device.
#include "renderer/kernels/raster.h"
#include "renderer/kernels/tile_grid.h"

namespace foverig {

static_assert(kTile == kRasterTile && kTile % kLanes == 0);

RIG_INLINE int spans_of(int columns) {
    return (columns + kLanes - 1) / kLanes;
}

/// Rows of `columns` elements each; the kernel has span(row, begin, end).
template <class Kernel>
struct RowSpans {
    Kernel kernel;
    int columns;

    static int count(int rows, int columns) { return rows * spans_of(columns); }

    RIG_HD void operator()(int i) const {
        const int begin = i % spans_of(columns) * kLanes;
        const int end = begin + kLanes < columns ? begin + kLanes : columns;
        kernel.span(i / spans_of(columns), begin, end);
    }
};

/// Floats of one plane of a frame's raster tiles; the last vector of the last row may touch more.
inline constexpr int kRasterTileFloats = kRasterTile * kRasterStride;

/// A kernel of one tile, moved to another of the frame. Its tile arrays lie one after the other.
template <class Kernel>
RIG_INLINE Kernel in_tile(Kernel kernel, int tile, const TileRect& rect) {
    kernel.x0 = rect.x0;
    kernel.y0 = rect.y0;
    if constexpr (requires { kernel.tile_width; }) kernel.tile_width = rect.width;
    if constexpr (requires { kernel.flags; }) kernel.flags += tile * kTilePixels;
    if constexpr (requires { kernel.tile.inverse_depth; }) {
        kernel.tile.inverse_depth += tile * kRasterTileFloats;
        kernel.tile.source_x_w += tile * kRasterTileFloats;
        kernel.tile.source_y_w += tile * kRasterTileFloats;
        kernel.tile.magnification += tile * kRasterTileFloats;
    }
    return kernel;
}

/// All tiles of a frame; the kernel is the first tile's and has span(row, begin, end).
template <class Kernel>
struct TileSpans {
    Kernel kernel;
    TileGrid grid;

    static constexpr int kSpans = kTile / kLanes;
    static int count(const TileGrid& grid) { return grid.count() * kTile * kSpans; }

    RIG_HD void operator()(int i) const {
        const int tile = i / (kTile * kSpans);
        const int y = i / kSpans % kTile;
        const int begin = i % kSpans * kLanes;
        const TileRect rect = grid.rect(tile);
        if (y >= rect.height || begin >= rect.width) return;
        const int end = begin + kLanes < rect.width ? begin + kLanes : rect.width;
        in_tile(kernel, tile, rect).span(y, begin, end);
    }
};

/// A kernel of samples that looks into its tile: element i lies in the tile of its pixel.
template <class Kernel>
struct InTileOfSample {
    Kernel kernel;
    TileGrid grid;

    RIG_HD void operator()(int i) const {
        const PackedPixel p = kernel.samples.pixels[i];
        const int tile = static_cast<int>(pixel_y(p)) / kTile * grid.columns() +
                         static_cast<int>(pixel_x(p)) / kTile;
        in_tile(kernel, tile, grid.rect(tile))(i);
    }
};

}  // namespace foverig
