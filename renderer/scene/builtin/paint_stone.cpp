#include "renderer/scene/builtin/hash.h"
#include "renderer/scene/builtin/noise.h"
#include "renderer/scene/builtin/painters.h"

namespace foverig::builtin {
namespace {

/// White noise of the texel under uv.
float grain(vec2 uv, std::uint32_t size_px, std::uint32_t seed) {
    const auto size = static_cast<float>(size_px);
    return unit_of(hash(static_cast<std::uint32_t>(uv.x * size),
                        static_cast<std::uint32_t>(uv.y * size), seed)) -
           0.5F;
}

}  // namespace

Canvas paint_stone(std::uint32_t size_px, const vec3& colour, std::uint32_t seed) {
    return paint_canvas(size_px, size_px, [&](vec2 uv) {
        const float cloud = fractal_noise(uv, 4, 5, seed);
        const float pit = smoothstep(0.35F, 0.6F, noise(uv * 48.0F, 48, seed + 9U));
        const float layer = 0.5F * noise({uv.x * 3.0F, uv.y * 24.0F}, 24, seed + 17U);
        const float light =
            1.0F + 0.28F * cloud + 0.06F * layer - 0.22F * pit + 0.08F * grain(uv, size_px, seed);
        return vec4{colour * light + vec3{0.02F, 0.01F, -0.01F} * cloud, 1.0F};
    });
}

Canvas paint_plaster(std::uint32_t size_px, const vec3& colour, std::uint32_t seed) {
    return paint_canvas(size_px, size_px, [&](vec2 uv) {
        const float cloud = fractal_noise(uv, 3, 6, seed);
        const float stain = smoothstep(0.12F, 0.5F, fractal_noise(uv, 2, 4, seed + 31U));
        const float crack =
            1.0F - smoothstep(0.0F, 0.03F, std::fabs(fractal_noise(uv, 5, 4, seed + 57U)));
        const float light = 1.0F + 0.14F * cloud + 0.05F * grain(uv, size_px, seed) -
                            0.10F * crack * smoothstep(0.0F, 0.3F, cloud);
        return vec4{mix(colour * light, colour * vec3{0.82F, 0.77F, 0.68F}, 0.6F * stain), 1.0F};
    });
}

Canvas paint_marble(std::uint32_t size_px, const vec3& colour, const vec3& vein,
                    std::uint32_t seed) {
    return paint_canvas(size_px, size_px, [&](vec2 uv) {
        const vec2 bent =
            uv + 0.12F * vec2{fractal_noise(uv, 3, 4, seed), fractal_noise(uv, 3, 4, seed + 5U)};
        const float thick =
            1.0F - smoothstep(0.0F, 0.10F, std::fabs(noise(bent * 4.0F, 4, seed + 11U)));
        const float thin =
            1.0F - smoothstep(0.0F, 0.07F, std::fabs(noise(bent * 11.0F, 11, seed + 13U)));
        const float cloud = fractal_noise(uv, 4, 4, seed + 23U);
        const vec3 ground = colour * (1.0F + 0.12F * cloud);
        return vec4{mix(ground, vein, clamp(0.55F * thick + 0.25F * thin, 0.0F, 1.0F)), 1.0F};
    });
}

}  // namespace foverig::builtin
