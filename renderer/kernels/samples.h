#pragma once
// The samples a frame traced, tile by tile, from shading to cache update.
#include <cstdint>

#include "renderer/half.h"
#include "renderer/kernels/compose.h"
#include "renderer/kernels/depth_mesh.h"
#include "renderer/kernels/support.h"

namespace foverig {

/// Why a pixel was traced; several may hold.
enum SampleFlag : std::uint8_t {
    kFovealSample = 1,   ///< inside r0
    kResampled = 2,      ///< the reprojection was found wanting there (3.3)
    kSupportSample = 4,  ///< belongs to the support image
    kChosenSample = 8,   ///< drawn by the foveal function
};

/// Arrays of one tile's samples, in queue order. The last three are null without a light buffer.
struct Samples {
    PackedPixel* pixels = nullptr;
    std::uint8_t* flags = nullptr;
    Half4* colour = nullptr;  ///< w = depth in metres (infinity from 65504 on)
    Half4* base = nullptr;    ///< colour without the stochastic light
    Half4* diffuse = nullptr;
    Half4* light = nullptr;  ///< irradiance rgb, openness
};

/// Files the i-th traced pixel as a sample, and in the support images where it belongs there.
template <bool kOcclusion, bool kLightBuffer>
struct StoreSamples {
    Surfaces surfaces;
    View<const std::uint32_t> slots;
    Samples samples;
    SupportImages support;
    const std::int16_t* support_column;  ///< of a pixel column; meaningful where the flag is set
    const std::int16_t* support_row;
    vec3 ambient;
    vec3 background;
    NumericCounts* numerics;

    RIG_HD void operator()(int i) const {
        const PackedPixel p = samples.pixels[i];
        const std::uint32_t slot = slots[static_cast<std::size_t>(i)];
        vec3 colour = background;
        vec3 base = background;
        vec3 diffuse{0.0F};
        vec4 light{0.0F, 0.0F, 0.0F, 1.0F};
        float depth = kFarDepth_m;
        if (slot != 0xFFFFFFFFU) {
            const int s = static_cast<int>(slot);
            colour = base = surfaces.get3(Row::colour_r, s);
            depth = surfaces.at(Row::depth, s);
            if constexpr (kLightBuffer) {
                diffuse = surfaces.get3(Row::diffuse_r, s);
                const vec3 irradiance = surfaces.get3(Row::irradiance_r, s);
                light = vec4(representable(irradiance), surfaces.at(Row::occlusion, s));
                colour = with_light(colour, diffuse, irradiance, light.w, ambient, kOcclusion);
            }
        }
        if (!is_finite(colour)) {  // what is mixed again later must stay black too
            base = diffuse = vec3(0.0F);
            light = {0.0F, 0.0F, 0.0F, 1.0F};
        }
        colour = checked(colour, *numerics);
        samples.colour[i] = pack_half4(vec4(colour, depth));
        if constexpr (kLightBuffer) {
            samples.base[i] = pack_half4(vec4(representable(base), 0.0F));
            samples.diffuse[i] = pack_half4(vec4(diffuse, 0.0F));
            samples.light[i] = pack_half4(light);
        }
        if ((samples.flags[i] & kSupportSample) != 0) {
            const int at = support_row[pixel_y(p)] * support.columns + support_column[pixel_x(p)];
            support.colour[at] = pack_half4(vec4(colour, 0.0F));
            support.depth_m[at] = depth;
            if constexpr (kLightBuffer) support.light[at] = pack_half4(light);
        }
    }
};

}  // namespace foverig
