#pragma once
// Queues of a whole frame: pixels in, those that see a surface out.
#include "renderer/kernels/pixel.h"
#include "renderer/kernels/sampling.h"
#include "renderer/kernels/tile_grid.h"
#include "renderer/trace/ray.h"
#include "renderer/view.h"

namespace foverig {

/// All pixels of an image, in blocks of 8 x 4: as many as a warp has lanes.
struct QueuePixels {
    int width_px;
    int height_px;
    View<PackedPixel> pixels;
    std::uint32_t eye;

    RIG_HD void operator()(int i) const {
        constexpr int kBlockWidth = 8;
        constexpr int kBlockHeight = 4;
        const int band = i / (width_px * kBlockHeight);
        const int y0 = band * kBlockHeight;
        const int height = height_px - y0 < kBlockHeight ? height_px - y0 : kBlockHeight;
        const int in_band = i - width_px * y0;
        const int block = in_band / (kBlockWidth * height);
        const int x0 = block * kBlockWidth;
        const int width = width_px - x0 < kBlockWidth ? width_px - x0 : kBlockWidth;
        const int in_block = in_band - x0 * height;
        pixels[static_cast<std::size_t>(i)] =
            of_eye(pack_pixel(static_cast<std::uint32_t>(x0 + in_block % width),
                              static_cast<std::uint32_t>(y0 + in_block / width)),
                   eye);
    }
};

struct SeesSurface {
    View<const Hit> hits;

    RIG_HD bool operator()(int i) const { return !hits[static_cast<std::size_t>(i)].missed(); }
};

/// `slot` is the i-th pixel's surface, or -1.
struct GiveSlot {
    View<const PackedPixel> pixels;
    View<std::uint32_t> slots;
    View<int> patterns;  ///< of each slot; empty: nothing is sampled by it

    RIG_HD void operator()(int i, int slot) const {
        slots[static_cast<std::size_t>(i)] = slot < 0 ? kMiss : static_cast<std::uint32_t>(slot);
        if (slot < 0 || patterns.empty()) return;
        const PackedPixel p = pixels[static_cast<std::size_t>(i)];
        patterns[static_cast<std::size_t>(slot)] = pattern_of(pixel_x(p), pixel_y(p));
    }
};

/// Whether the pixel at the i-th place is to be traced. Places go tile by tile, each in coherent
/// order; flags lie 64 a row in each tile (see SelectPixels).
struct IsChosen {
    const std::uint8_t* flags;

    RIG_HD bool operator()(int i) const {
        return flags[i / kTilePixels * kTilePixels + coherent_pixel(i % kTilePixels)] != 0;
    }
};

/// Files the pixel at the i-th place as a sample, if it got a place in the queue.
struct QueueSample {
    const std::uint8_t* flags;
    TileGrid grid;
    PackedPixel* pixels;
    std::uint8_t* why;
    std::uint32_t eye;

    RIG_HD void operator()(int i, int place) const {
        if (place < 0) return;
        const int tile = i / kTilePixels;
        const int pixel = coherent_pixel(i % kTilePixels);
        const TileRect rect = grid.rect(tile);
        pixels[place] = of_eye(pack_pixel(static_cast<std::uint32_t>(rect.x0 + pixel % kTile),
                                          static_cast<std::uint32_t>(rect.y0 + pixel / kTile)),
                               eye);
        why[place] = flags[tile * kTilePixels + pixel];
    }
};

}  // namespace foverig
