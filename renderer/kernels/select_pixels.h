#pragma once
#include <cstdint>

#include "renderer/foveation/foveal_function.h"
#include "renderer/kernels/camera_rays.h"
#include "renderer/kernels/resampling.h"
#include "renderer/kernels/samples.h"
#include "renderer/kernels/sampling.h"

namespace foverig {

/// How eccentricity varies in a tile: most tiles need no angle at all.
enum class TileZone { foveal, falloff, peripheral };

/// One row of a tile: why each pixel is to be traced, as SampleFlags; 0 for most. A pixel is drawn
/// where xi < p(q) (Weier 2016 3.1), xi a hash of pixel and frame.
struct SelectPixels {
    FovealFunction foveal;
    EyeRays eye;
    vec3 gaze;  ///< unit, world
    std::uint32_t frame_seed;
    CoarseLookup resampled;
    const std::int16_t* support_column;  ///< index of the support column at a pixel column, or -1
    const std::int16_t* support_row;
    TileZone zone;
    int x0;
    int y0;
    int tile_width;
    std::uint8_t* flags;  ///< 64 a row

    RIG_HD void operator()(int y) const { span(y, 0, tile_width); }

    /// Pixels [begin, end) of the row.
    RIG_INLINE void span(int y, int begin, int end) const {
        std::uint8_t* const row = flags + y * 64;
        if (zone == TileZone::falloff)
            draw<true>(y, begin, end, row);
        else
            draw<false>(y, begin, end, row);
        if (resampled.marked != nullptr) {
            const std::uint8_t* const marked =
                resampled.marked + resampled.row_of[y0 + y] * resampled.columns;
            for (int x = begin; x < end; ++x)
                row[x] |= marked[resampled.column_of[x0 + x]] != 0 ? kResampled : 0;
        }
        if (support_row[y0 + y] >= 0)
            for (int x = begin; x < end; ++x)
                row[x] |= support_column[x0 + x] >= 0 ? kSupportSample : 0;
    }

    template <bool kFalloff>
    RIG_HD void draw(int y, int begin, int end, std::uint8_t* row) const {
        const float uniform = zone == TileZone::foveal ? 1.0F : foveal.p_min;
        const std::uint8_t uniform_flag = zone == TileZone::foveal ? kFovealSample : 0;
        const std::uint32_t row_seed = hash32(frame_seed + static_cast<std::uint32_t>(y0 + y));
        const vec3 left =
            eye.direction(static_cast<float>(x0) + 0.5F, static_cast<float>(y0 + y) + 0.5F);
        const FovealFunction f = foveal;
        const vec3 g = gaze;
        const vec3 step = eye.step_x;
        const std::uint32_t first = static_cast<std::uint32_t>(x0);
#pragma GCC ivdep
        for (int x = begin; x < end; ++x) {
            const float xi = unit_float(hash32(row_seed ^ (first + static_cast<std::uint32_t>(x))));
            if constexpr (kFalloff) {
                const float fx = static_cast<float>(x);
                const float dx = left.x + fx * step.x;
                const float dy = left.y + fx * step.y;
                const float dz = left.z + fx * step.z;
                const float cx = g.y * dz - g.z * dy;
                const float cy = g.z * dx - g.x * dz;
                const float cz = g.x * dy - g.y * dx;
                const float eccentricity = fast_angle_rad(sqrtf(cx * cx + cy * cy + cz * cz),
                                                          g.x * dx + g.y * dy + g.z * dz);
                const float ramp = 1.0F + f.slope_per_rad * (eccentricity - f.r0_rad);
                // Rather a pixel too many in the fovea than one too few: its equality with `full`
                // is promised.
                const bool inside = eccentricity <= f.r0_rad + kFastAngleError_rad;
                const float p = inside ? 1.0F : (eccentricity >= f.r1_rad ? f.p_min : ramp);
                row[x] = static_cast<std::uint8_t>((xi < p ? kChosenSample : 0) |
                                                   (inside ? kFovealSample : 0));
            } else {
                row[x] =
                    static_cast<std::uint8_t>((xi < uniform ? kChosenSample : 0) | uniform_flag);
            }
        }
    }
};

}  // namespace foverig
