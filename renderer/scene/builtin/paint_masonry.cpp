#include <algorithm>

#include "renderer/scene/builtin/hash.h"
#include "renderer/scene/builtin/noise.h"
#include "renderer/scene/builtin/painters.h"

namespace foverig::builtin {

Canvas paint_masonry(std::uint32_t size_px, const Masonry& masonry, std::uint32_t seed) {
    const auto across = static_cast<float>(masonry.across);
    const auto rows = static_cast<float>(masonry.rows);
    const float slimness = rows / across;
    return paint_canvas(size_px, size_px, [&](vec2 uv) {
        const float row = std::floor(uv.y * rows);
        const bool odd = masonry.shifted && static_cast<int>(row) % 2 == 1;
        const float along = uv.x * across + (odd ? 0.5F : 0.0F);
        const auto stone =
            static_cast<std::uint32_t>(static_cast<int>(std::floor(along)) % masonry.across);
        const std::uint32_t id = hash(stone, static_cast<std::uint32_t>(row), seed);
        // Distance to the stone's edge, in stone heights, roughened so that joints are not ruled.
        const float fx = fract(along);
        const float fy = fract(uv.y * rows);
        const float rough = 0.03F * noise(uv * 32.0F, 32, seed + 3U);
        const float to_edge =
            std::min(std::min(fx, 1.0F - fx) * slimness, std::min(fy, 1.0F - fy)) + rough;
        const float body = smoothstep(0.4F * masonry.joint, masonry.joint, to_edge);
        const float lit_rim = smoothstep(masonry.joint, 3.0F * masonry.joint, to_edge);
        const float tone = (unit_of(id) - 0.5F) * 2.0F * masonry.variety;
        const float warm = (unit_of(hash(id)) - 0.5F) * masonry.variety;
        const float cloud = fractal_noise(uv, 8, 4, seed + 7U);
        const vec3 stone_colour = masonry.stone * (0.9F + 0.1F * lit_rim + tone + 0.25F * cloud) +
                                  vec3{warm, 0.3F * warm, -0.4F * warm};
        const vec3 mortar = masonry.mortar * (0.82F + 0.3F * cloud);
        return vec4{mix(mortar, stone_colour, body), 1.0F};
    });
}

Canvas paint_roof_tiles(std::uint32_t size_px, const vec3& colour, std::uint32_t seed) {
    constexpr float kTiles = 8.0F;
    return paint_canvas(size_px, size_px, [&](vec2 uv) {
        const float row = std::floor(uv.y * kTiles);
        const float along = uv.x * kTiles + (static_cast<int>(row) % 2 == 1 ? 0.5F : 0.0F);
        const auto tile = static_cast<std::uint32_t>(static_cast<int>(std::floor(along)) % 8);
        const float tone = unit_of(hash(tile, static_cast<std::uint32_t>(row), seed));
        const float round = sine(0.5F * fract(along));
        const float overlap = smoothstep(0.0F, 0.25F, fract(uv.y * kTiles));
        const float cloud = fractal_noise(uv, 6, 4, seed + 3U);
        return vec4{colour * (0.35F + 0.45F * round) * (0.55F + 0.45F * overlap) *
                        (1.05F + 0.3F * tone + 0.3F * cloud),
                    1.0F};
    });
}

Canvas paint_inlay(std::uint32_t size_px, const vec3& light, const vec3& dark, const vec3& accent,
                   std::uint32_t seed) {
    return paint_canvas(size_px, size_px, [&](vec2 uv) {
        const float x = std::fabs(uv.x - 0.5F);
        const float y = std::fabs(uv.y - 0.5F);
        const float to_side = 0.5F - std::max(x, y);
        const float lozenge = x + y;
        vec3 colour = light;
        if (to_side < 0.075F) colour = dark;
        if (to_side < 0.05F) colour = light * 0.93F;
        if (to_side >= 0.075F && lozenge < 0.40F) colour = dark * 1.1F;
        if (lozenge < 0.36F) colour = light;
        if (lozenge < 0.17F) colour = accent;
        const float bent = fractal_noise(uv, 3, 4, seed);
        const float vein =
            1.0F - smoothstep(0.0F, 0.08F, std::fabs(noise(uv * 6.0F + bent, 6, seed + 5U)));
        const float joint = smoothstep(0.0F, 0.008F, to_side);
        return vec4{colour * (1.0F + 0.16F * bent - 0.12F * vein) * (0.45F + 0.55F * joint), 1.0F};
    });
}

}  // namespace foverig::builtin
