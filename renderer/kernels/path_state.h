#pragma once
#include "renderer/kernels/pixel.h"
#include "renderer/trace/ray.h"
#include "renderer/view.h"

namespace foverig {

/// The paths of one sample of one tile, one a queued pixel: what the next ray is, and what it will
/// be worth.
struct PathStates {
    View<const PackedPixel> pixels;  ///< by path
    View<std::uint32_t> queue;       ///< paths that still run, in path order
    View<vec3> origin_m;             ///< by path, as all below
    View<vec3> direction;
    View<vec3> throughput;
    View<vec3> radiance;          ///< gathered so far
    View<std::uint8_t> mirrored;  ///< 1: the ray comes from a mirror, and sees lamps and background

    RIG_HD std::size_t path(int i) const { return queue[static_cast<std::size_t>(i)]; }
};

}  // namespace foverig
