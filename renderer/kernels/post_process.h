#pragma once
#include "renderer/kernels/cache_update.h"
#include "renderer/kernels/resampling.h"
#include "renderer/kernels/sampling.h"

namespace foverig {

/// How much of the way from `own` to `other` light sampling alone explains: visibility, the share v
/// of `most`, found by n rays is off by sqrt(v (1 - v) / n). `noise` is half of 1 / sqrt(n), since
/// the points are stratified. 0 to 1.
RIG_INLINE float share_of_noise(float own, float other, float most, float noise) {
    const float apart = fabsf(other - own);
    if (!(apart > 0.0F)) return 1.0F;
    const float v = min_of(min_of(own, other) / most, 1.0F);
    const float wide = noise * most * sqrtf(v * (1.0F - v));
    return apart > wide ? wide / apart : 1.0F;
}

/// `noise` of n rays.
inline float light_noise(int samples) {
    return 0.5F / sqrtf(static_cast<float>(samples > 0 ? samples : 1));
}

/// Light-buffer post-process (Weier 2016 3.5) for the i-th sample of a tile, if it was resampled
/// outside the fovea: finds the nearest reconstructed neighbour on the axes, samples the window of
/// that size n times, and lights the pixel with the light of the closest reconstructed pixel found,
/// as far as the two lie on one surface and differ by no more than noise (docs/reprojected.md).
/// The fovea keeps its own light: there the image is promised to equal the full renderer's.
template <bool kOcclusion>
struct PostProcess {
    Samples samples;
    HistoryImages images;
    CoarseLookup resampled;
    const float* inverse_depth;  ///< by coarse cell
    float epsilon_depth;         ///< of the sample's depth: the same surface
    float irradiance_noise;      ///< see share_of_noise
    float openness_noise;
    vec3 ambient;
    int window_samples;
    int search_px;
    std::uint32_t frame_seed;
    int width_px;
    int height_px;

    RIG_HD vec4 mixed(const vec4& own, const vec4& other) const {
        const float own_y = luminance(vec3(own));
        const float other_y = luminance(vec3(other));
        const float e = share_of_noise(own_y, other_y, max_of(own_y, other_y), irradiance_noise);
        const float o = share_of_noise(own.w, other.w, 1.0F, openness_noise);
        return vec4(vec3(own) + (vec3(other) - vec3(own)) * e, own.w + (other.w - own.w) * o);
    }

    RIG_HD void operator()(int i) const {
        if ((samples.flags[i] & (kResampled | kFovealSample)) != kResampled) return;
        const int x = static_cast<int>(pixel_x(samples.pixels[i]));
        const int y = static_cast<int>(pixel_y(samples.pixels[i]));
        const int window = resampled.distance_to_unmarked(x, y, search_px);
        if (window == 0) return;
        const float inverse_sample = 1.0F / unpack_half4(samples.colour[i]).w;
        int best = window * window + 1;
        int from = -1;
        const auto consider = [&](int px, int py) {
            const int distance2 = (px - x) * (px - x) + (py - y) * (py - y);
            if (distance2 >= best || px < 0 || py < 0 || px >= width_px || py >= height_px) return;
            const int cell = resampled.cell(px, py);
            if (resampled.marked[cell] != 0 ||
                fabsf(inverse_depth[cell] - inverse_sample) > epsilon_depth * inverse_sample)
                return;
            best = distance2;
            from = py * width_px + px;
        };
        consider(x - window, y);
        consider(x + window, y);
        consider(x, y - window);
        consider(x, y + window);
        std::uint32_t h =
            hash32(frame_seed ^ pack_pixel(pixel_x(samples.pixels[i]), pixel_y(samples.pixels[i])));
        for (int k = 0; k < window_samples && best > 1; ++k) {  // 1: none can be nearer
            h = hash32(h + 0x9E3779B9U);
            const int span = 2 * window + 1;
            consider(x - window +
                         static_cast<int>((h & 0xFFFFU) * static_cast<std::uint32_t>(span) >> 16U),
                     y - window +
                         static_cast<int>((h >> 16U) * static_cast<std::uint32_t>(span) >> 16U));
        }
        if (from < 0) return;
        const vec4 light = mixed(unpack_half4(samples.light[i]), unpack_half4(images.light[from]));
        const vec3 colour =
            with_light(vec3(unpack_half4(samples.base[i])), vec3(unpack_half4(samples.diffuse[i])),
                       vec3(light), light.w, ambient, kOcclusion);
        const int target = y * width_px + x;
        const float rho = unpack_half4(images.colour[target]).w;
        images.colour[target] = pack_half4(vec4(representable(colour), rho));
    }
};

}  // namespace foverig
