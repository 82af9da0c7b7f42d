#pragma once
#include "renderer/half.h"
#include "renderer/kernels/raster.h"
#include "renderer/kernels/running_estimate.h"

namespace foverig {

inline constexpr float kWidestFootprint_px = 4.0F;
/// Pixel (x, y) uses the taps of (x mod 8, y mod 8): a row of eight is one vector load.
inline constexpr int kTapPeriod = 8;

/// Normally distributed offsets in footprints, drawn anew each frame: [tap][axis][y mod 8][x mod
/// 8].
struct TapTable {
    const float* offsets = nullptr;

    RIG_HD const float* row(int tap, int axis, int y) const {
        return offsets + ((tap * 2 + axis) * kTapPeriod + y) * kTapPeriod;
    }
};

/// Image of a frame that later frames reuse. `light` is null without a light buffer.
struct HistoryImages {
    Half4* colour = nullptr;  ///< final colour; w = rho
    CacheInfo* info = nullptr;
    Half4* light = nullptr;  ///< irradiance rgb, openness
};

/// One row of a tile: colour and cache info of the last frame under the new view. Filtering by a
/// few normally distributed taps of the pixel's footprint (3.2); uncovered pixels are left to
/// `merge`.
template <int kTaps, bool kLightBuffer>
struct ReprojectPixels {
    RasterTile tile;
    TapTable taps;
    HistoryImages from;
    HistoryImages to;
    int x0;
    int y0;
    int tile_width;
    int width_px;
    int height_px;

    RIG_HD void operator()(int y) const { span(y, 0, tile_width); }

    /// Pixels [begin, end) of the row; on the device one at a time.
    RIG_INLINE void span(int y, int begin, int end) const {
        constexpr int kMost = kLanes == 1 ? 1 : kRasterTile;
        const auto place = [begin](int x) { return kMost == 1 ? 0 : x - begin; };
        alignas(64) int indices[kTaps][kMost];
        const Lanes zero{};
        const Lanes one = zero + 1.0F;
        const Lanes last_x = zero + static_cast<float>(width_px - 1);
        const Lanes last_y = zero + static_cast<float>(height_px - 1);
        for (int x = begin; x < end; x += kLanes) {
            const int at = y * kRasterStride + x;
            const Lanes inverse_depth = load_lanes(tile.inverse_depth + at);
            const Lanes depth = one / select_lanes(inverse_depth > zero, inverse_depth, one);
            const Lanes source_x = load_lanes(tile.source_x_w + at) * depth;
            const Lanes source_y = load_lanes(tile.source_y_w + at) * depth;
            // A magnified pixel still sees one texel; a strongly minified one is a silhouette's
            // smear.
            const Lanes width =
                sqrt_lanes(min_lanes(max_lanes(load_lanes(tile.magnification + at), one),
                                     zero + kWidestFootprint_px * kWidestFootprint_px));
            for (int k = 0; k < kTaps; ++k) {
                const Lanes tap_x = source_x + width * load_lanes(taps.row(k, 0, y & 7) + (x & 7));
                const Lanes tap_y = source_y + width * load_lanes(taps.row(k, 1, y & 7) + (x & 7));
                const LaneInts column = truncate_lanes(max_lanes(min_lanes(tap_x, last_x), zero));
                const LaneInts row = truncate_lanes(max_lanes(min_lanes(tap_y, last_y), zero));
                store_lanes(indices[k] + place(x), row * width_px + column);
            }
        }
        const std::size_t out =
            static_cast<std::size_t>(y0 + y) * static_cast<std::size_t>(width_px) +
            static_cast<std::size_t>(x0);
        const float* const covered = tile.inverse_depth + y * kRasterStride;
        for (int x = begin; x < end; ++x) {
            if (covered[x] <= 0.0F) continue;
            const std::size_t target = out + static_cast<std::size_t>(x);
            to.colour[target] = mean_half4<kTaps>(from.colour, indices[0] + place(x), kMost);
            to.info[target] = from.info[indices[0][place(x)]];
            if constexpr (kLightBuffer) to.light[target] = from.light[indices[0][place(x)]];
        }
    }
};

}  // namespace foverig
