#pragma once
// Queues of a whole frame: pixels in, those that see a surface out.
#include "renderer/kernels/pixel.h"
#include "renderer/kernels/sampling.h"
#include "renderer/trace/ray.h"
#include "renderer/view.h"

namespace foverig {

/// All pixels of an image, in blocks of 8 x 4: as many as a warp has lanes.
struct QueuePixels {
    int width_px;
    int height_px;
    View<PackedPixel> pixels;

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
            pack_pixel(static_cast<std::uint32_t>(x0 + in_block % width),
                       static_cast<std::uint32_t>(y0 + in_block / width));
    }
};

struct SeesSurface {
    View<const Hit> hits;

    RIG_HD bool operator()(int i) const { return !hits[static_cast<std::size_t>(i)].missed(); }
};

/// `slot` is the i-th pixel's surface, or -1. Fills the queue of surfaces too, where something is
/// sampled by it.
struct GiveSlot {
    View<const PackedPixel> pixels;
    View<std::uint32_t> slots;
    View<int> own_slots;  ///< entry k is k; empty: not wanted
    View<int> patterns;   ///< of each slot; empty: not wanted

    RIG_HD void operator()(int i, int slot) const {
        slots[static_cast<std::size_t>(i)] = slot < 0 ? kMiss : static_cast<std::uint32_t>(slot);
        if (slot < 0) return;
        const PackedPixel p = pixels[static_cast<std::size_t>(i)];
        if (!own_slots.empty()) own_slots[static_cast<std::size_t>(slot)] = slot;
        if (!patterns.empty())
            patterns[static_cast<std::size_t>(slot)] = pattern_of(pixel_x(p), pixel_y(p));
    }
};

}  // namespace foverig
