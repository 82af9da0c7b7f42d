#pragma once
#include "renderer/effects/memory.h"
#include "renderer/kernels/pixel.h"
#include "renderer/kernels/surface.h"
#include "renderer/kernels/tile_grid.h"
#include "renderer/pipelines/occlusion_queue.h"
#include "renderer/renderer.h"
#include "renderer/trace/ray.h"

namespace foverig {

/// Queues and surface records of the tile that a thread works on; reused from tile to tile.
struct TileScratch {
    TileScratch(EffectMemory& memory, const EffectPlan& plan);

    Surfaces surfaces() { return {rows.data(), kStride}; }

    /// Room for a whole packet past the last slot.
    static constexpr int kStride = kTilePixels + 16;

    Buffer<PackedPixel> pixels;   ///< the primary queue
    Buffer<Hit> hits;             ///< one a queued pixel
    Buffer<std::uint32_t> slots;  ///< surface slot of a queued pixel, or kMiss
    Buffer<int> patterns;         ///< sampling pattern by slot; only with an area light
    const std::uint8_t* sparse =
        nullptr;         ///< by queued pixel: 1 where neighbours are not traced; null = none
    Buffer<float> rows;  ///< surface records
    OcclusionQueue occlusion;
    RayCounts rays;
    NumericCounts numerics;
    std::uint64_t sampled_pixels = 0;
};

}  // namespace foverig
