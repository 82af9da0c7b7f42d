#include <algorithm>

#include "renderer/scene/builtin/hash.h"
#include "renderer/scene/builtin/noise.h"
#include "renderer/scene/builtin/painters.h"

namespace foverig::builtin {

Canvas paint_planks(std::uint32_t size_px, const vec3& colour, int planks, std::uint32_t seed) {
    const auto count = static_cast<float>(planks);
    return paint_canvas(size_px, size_px, [&](vec2 uv) {
        const float across = uv.x * count;
        const auto plank = static_cast<std::uint32_t>(across);
        const float tone = unit_of(hash(plank, seed)) - 0.5F;
        const float bent = 0.15F * noise(uv * 4.0F, 4, seed + plank);
        const float rings =
            noise({(uv.x + 0.1F * bent) * 48.0F, uv.y * 4.0F}, 48, seed + 7U * plank);
        const float fine = noise({uv.x * 128.0F, uv.y * 8.0F}, 128, seed + 3U);
        const float gap = smoothstep(0.0F, 0.05F, std::min(fract(across), 1.0F - fract(across)));
        const float light =
            (1.0F + 0.3F * tone + 0.22F * rings + 0.1F * fine) * (0.35F + 0.65F * gap);
        return vec4{colour * light, 1.0F};
    });
}

Canvas paint_bark(std::uint32_t size_px, const vec3& colour, std::uint32_t seed) {
    return paint_canvas(size_px, size_px, [&](vec2 uv) {
        const float bent = 0.06F * fractal_noise(uv, 4, 3, seed);
        const float ridge = noise({(uv.x + bent) * 16.0F, uv.y * 4.0F}, 16, seed + 3U);
        const float crack = smoothstep(0.05F, 0.4F, std::fabs(ridge));
        return vec4{colour * (0.55F + 0.5F * crack + 0.25F * fractal_noise(uv, 8, 4, seed + 5U)),
                    1.0F};
    });
}

}  // namespace foverig::builtin
