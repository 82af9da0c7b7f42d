#pragma once
#include "renderer/kernels/raster.h"
#include "renderer/kernels/reproject_pixels.h"
#include "renderer/kernels/samples.h"

namespace foverig {

/// Combines the i-th sample of a tile with what was reprojected there (Weier 2016 3.4). Foveal and
/// resampled pixels, uncovered ones and those whose depth disagrees take the sample alone; with
/// oversampling, foveal and resampled ones are accumulated too (5).
template <bool kOcclusion, bool kLightBuffer, bool kOversampling>
struct CacheUpdate {
    RasterTile tile;
    Samples samples;
    HistoryImages to;
    SmallestWeight colour_weight;
    SmallestWeight light_weight;
    vec3 ambient;
    float epsilon_depth;
    std::uint32_t frame;
    int x0;
    int y0;
    int width_px;

    RIG_HD void operator()(int i) const {
        const int x = static_cast<int>(pixel_x(samples.pixels[i]));
        const int y = static_cast<int>(pixel_y(samples.pixels[i]));
        const auto target = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) +
                            static_cast<std::size_t>(x);
        const vec4 sample = unpack_half4(samples.colour[i]);
        const float inverse_depth = tile.inverse_depth[(y - y0) * kRasterStride + x - x0];
        // |d_cache - d_sample| <= epsilon d_sample, divided by both: holds for far depths (1/inf =
        // 0) too.
        const float inverse_sample = 1.0F / sample.w;
        const bool agrees = inverse_depth > 0.0F && fabsf(inverse_depth - inverse_sample) <=
                                                        epsilon_depth * inverse_depth + kInverseFar;
        const bool direct =
            !kOversampling && (samples.flags[i] & (kFovealSample | kResampled)) != 0;
        if (direct || !agrees) {
            to.colour[target] = pack_half4(vec4(vec3(sample), 1.0F));
            to.info[target] = touched_in(frame);
            if constexpr (kLightBuffer) to.light[target] = samples.light[i];
            return;
        }
        const vec4 cached = unpack_half4(to.colour[target]);
        const std::uint32_t age = age_frames(to.info[target], frame);
        const float alpha = new_sample_weight(cached.w, colour_weight(age));
        vec3 colour = vec3(sample);
        if constexpr (kLightBuffer) {
            const float light_alpha = new_sample_weight(cached.w, light_weight(age));
            const vec4 light = light_alpha * unpack_half4(samples.light[i]) +
                               (1.0F - light_alpha) * unpack_half4(to.light[target]);
            to.light[target] = pack_half4(light);
            colour = with_light(vec3(unpack_half4(samples.base[i])),
                                vec3(unpack_half4(samples.diffuse[i])), vec3(light), light.w,
                                ambient, kOcclusion);
        }
        to.colour[target] =
            pack_half4(vec4(alpha * representable(colour) + (1.0F - alpha) * vec3(cached),
                            accumulated_samples(cached.w, alpha)));
        to.info[target] = touched_in(frame);
    }

    /// 1/m: depths beyond half's range count as equally far.
    static constexpr float kInverseFar = 1.0F / kLargestHalf;
};

}  // namespace foverig
