#pragma once
#include "renderer/kernels/path_vertex.h"
#include "renderer/pipelines/shade_tile.h"

namespace foverig {

/// What a thread needs besides TileScratch to trace one tile's paths.
struct PathScratch {
    explicit PathScratch(MemoryCount& memory);

    PathStates states(const TileScratch& tile);

    Buffer<std::uint32_t> queue;
    Buffer<vec3> vectors;  ///< origin, direction, throughput, radiance, kStride each
    Buffer<std::uint8_t> mirrored;
    Buffer<std::uint32_t> path_of;  ///< by surface slot
    Buffer<std::uint32_t> triangle_of;
};

/// One sample of the first `n` pixels of `tile.pixels`, added to `sums`: direct light as `full`
/// models it at every vertex, up to `max_bounces` further vertices. Adds to the tile's ray counts.
void trace_paths(Lane& lane, TileScratch& tile, PathScratch& scratch, const ShadingFrame& frame,
                 int n, const PathSampler& sampler, int max_bounces, const HalfSums& sums);

}  // namespace foverig
