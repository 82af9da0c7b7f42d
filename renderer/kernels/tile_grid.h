#pragma once
#include <array>
#include <cstdint>

#include "renderer/hd.h"

namespace foverig {

/// Tiles of 64x64 pixels: their queues and surface records stay in a core's L2.
inline constexpr int kTile = 64;
inline constexpr int kTilePixels = kTile * kTile;

struct TileRect {
    int x0 = 0;
    int y0 = 0;
    int width = 0;  ///< clipped to the image
    int height = 0;
};

struct TileGrid {
    int width_px = 0;
    int height_px = 0;

    RIG_HD int columns() const { return (width_px + kTile - 1) / kTile; }
    RIG_HD int rows() const { return (height_px + kTile - 1) / kTile; }
    RIG_HD int count() const { return columns() * rows(); }
    RIG_HD TileRect rect(int tile) const {
        TileRect r;
        r.x0 = tile % columns() * kTile;
        r.y0 = tile / columns() * kTile;
        r.width = width_px - r.x0 < kTile ? width_px - r.x0 : kTile;
        r.height = height_px - r.y0 < kTile ? height_px - r.y0 : kTile;
        return r;
    }
};

/// The order in which a tile's pixels are queued: 4x4 blocks (one packet) along a Morton curve, so
/// that compacted queues stay coherent by construction. Place i holds pixel y * 64 + x of the tile.
RIG_HD constexpr int coherent_pixel(int i) {
    const int block = i >> 4;
    int bx = 0;
    int by = 0;
    for (int bit = 0; bit < 4; ++bit) {
        bx |= ((block >> (2 * bit)) & 1) << bit;
        by |= ((block >> (2 * bit + 1)) & 1) << bit;
    }
    return (by * 4 + ((i >> 2) & 3)) * kTile + bx * 4 + (i & 3);
}

constexpr std::array<std::uint16_t, kTilePixels> make_coherent_order() {
    std::array<std::uint16_t, kTilePixels> order{};
    for (int i = 0; i < kTilePixels; ++i)
        order[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(coherent_pixel(i));
    return order;
}

inline constexpr std::array<std::uint16_t, kTilePixels> kCoherentOrder = make_coherent_order();

}  // namespace foverig
