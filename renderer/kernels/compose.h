#pragma once
#include <limits>

#include "renderer/counts.h"
#include "renderer/half.h"
#include "renderer/kernels/light_rays.h"

namespace foverig {

/// `colour` and the light buffer's share of it: kd (E / pi + ambient * openness). Fused by hand: a
/// compiler may fuse either product of a sum, and the pipelines' colours are to be equal.
RIG_INLINE vec3 with_light(const vec3& colour, const vec3& diffuse, const vec3& irradiance,
                           float openness, const vec3& ambient, bool occluded) {
    const auto channel = [&](int c) {
        const float shown = occluded ? ambient[c] * openness : 0.0F;
        return fmaf(diffuse[c], fmaf(irradiance[c], kInversePi, shown), colour[c]);
    };
    return {channel(0), channel(1), channel(2)};
}

RIG_INLINE bool is_finite(const vec3& c) {
    constexpr float most = std::numeric_limits<float>::max();
    return fabsf(c.x) <= most && fabsf(c.y) <= most && fabsf(c.z) <= most;
}

/// NaN and infinity are counted and shown black, a colour too bright for a half is counted and
/// clamped, so that one bad pixel cannot spread through history.
RIG_INLINE vec3 checked(const vec3& c, NumericCounts& counts) {
    if (is_finite(c)) {
        if (max_of(max_of(c.x, c.y), c.z) <= kLargestHalf) return c;
        count_one(counts.clamped);
        return representable(c);
    }
    if (fabsf(c.x) + fabsf(c.y) + fabsf(c.z) > 0.0F)  // false for NaN
        count_one(counts.inf);
    else
        count_one(counts.nan);
    return vec3(0.0F);
}

/// Final colour of the i-th queued pixel, straight into an image (the `full` pipeline's last pass).
template <bool kOcclusion, bool kLightBuffer>
struct ComposePixels {
    Surfaces surfaces;
    View<const PackedPixel> pixels;
    View<const std::uint32_t> slots;
    vec3 ambient;
    vec3 background;
    View<Half4> image;
    int width_px;
    NumericCounts* numerics;

    RIG_HD void operator()(int i) const {
        const PackedPixel p = pixels[static_cast<std::size_t>(i)];
        const std::uint32_t slot = slots[static_cast<std::size_t>(i)];
        vec3 colour = background;
        if (slot != 0xFFFFFFFFU) {
            const int s = static_cast<int>(slot);
            colour = surfaces.get3(Row::colour_r, s);
            if constexpr (kLightBuffer)
                colour = with_light(colour, surfaces.get3(Row::diffuse_r, s),
                                    surfaces.get3(Row::irradiance_r, s),
                                    surfaces.at(Row::occlusion, s), ambient, kOcclusion);
        }
        image[static_cast<std::size_t>(pixel_y(p)) * static_cast<std::size_t>(width_px) +
              pixel_x(p)] = pack_half4(vec4(checked(colour, *numerics), 0.0F));
    }
};

}  // namespace foverig
