#pragma once
#include "renderer/kernels/reproject_pixels.h"
#include "renderer/kernels/support.h"

namespace foverig {

/// One row of a tile: what the mesh did not cover is filled from the support image (3.4). Such a
/// pixel was never sampled: rho = 0, so that its first sample replaces it.
template <bool kLightBuffer>
struct MergeSupport {
    RasterTile tile;
    SupportLookup lookup;
    HistoryImages to;
    int x0;
    int y0;
    int tile_width;
    int width_px;
    std::uint32_t frame;

    RIG_HD void operator()(int y) const { span(y, 0, tile_width); }

    /// Pixels [begin, end) of the row.
    RIG_INLINE void span(int y, int begin, int end) const {
        for (int x = begin; x < end; ++x) {
            if (tile.inverse_depth[y * kRasterStride + x] > 0.0F) continue;
            const std::size_t target =
                static_cast<std::size_t>(y0 + y) * static_cast<std::size_t>(width_px) +
                static_cast<std::size_t>(x0 + x);
            to.colour[target] =
                pack_half4(vec4(vec3(lookup(lookup.support.colour, x0 + x, y0 + y)), 0.0F));
            to.info[target] = touched_in(frame);
            if constexpr (kLightBuffer)
                to.light[target] = pack_half4(lookup(lookup.support.light, x0 + x, y0 + y));
        }
    }
};

}  // namespace foverig
