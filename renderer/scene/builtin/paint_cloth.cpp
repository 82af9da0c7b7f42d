#include <algorithm>

#include "renderer/scene/builtin/noise.h"
#include "renderer/scene/builtin/painters.h"

namespace foverig::builtin {
namespace {

/// Four-lobed rosette around the middle of a unit cell: > 0 inside.
float rosette(vec2 cell) {
    const float x = std::fabs(cell.x - 0.5F);
    const float y = std::fabs(cell.y - 0.5F);
    const float lobe_x = 0.15F - length(vec2{x - 0.17F, y});
    const float lobe_y = 0.15F - length(vec2{x, y - 0.17F});
    const float heart = 0.07F - length(vec2{x, y});
    const float leaf = 0.09F - (std::fabs(x - y) + 0.35F * std::fabs(x + y - 0.62F));
    return heart > -0.025F ? heart : std::max({lobe_x, lobe_y, leaf});
}

}  // namespace

Canvas paint_damask(std::uint32_t size_px, const vec3& ground, const vec3& motif,
                    std::uint32_t seed) {
    constexpr float kMotifs = 4.0F;
    return paint_canvas(size_px, size_px, [&](vec2 uv) {
        const float row = std::floor(uv.y * kMotifs);
        const float shift = static_cast<int>(row) % 2 == 1 ? 0.5F : 0.0F;
        const vec2 cell{fract(uv.x * kMotifs + shift), fract(uv.y * kMotifs)};
        const float inside = smoothstep(-0.012F, 0.012F, rosette(cell));
        const auto size = static_cast<float>(size_px);
        const float weave = 0.05F * (sine(uv.x * size / 4.0F) + sine(uv.y * size / 4.0F));
        const float worn = 1.0F + 0.15F * fractal_noise(uv, 4, 4, seed) + weave;
        return vec4{mix(ground, motif, inside) * worn, 1.0F};
    });
}

Canvas paint_lace(std::uint32_t size_px, const vec3& thread, const vec3& border) {
    constexpr float kMeshes = 12.0F;
    return paint_canvas(size_px, size_px, [&](vec2 uv) {
        const float a = fract((uv.x + uv.y) * kMeshes);
        const float b = fract((uv.x - uv.y) * kMeshes + kMeshes);
        const float strand = std::min(std::min(a, 1.0F - a), std::min(b, 1.0F - b));
        const vec2 knot{std::fabs(a - 0.5F), std::fabs(b - 0.5F)};
        const vec2 cell{fract(uv.x * 3.0F), fract(uv.y * 3.0F)};
        const bool flower = rosette(cell) > 0.0F;
        const bool top_band = uv.y < 0.04F;
        const bool low_band = uv.y > 0.84F && uv.y < 0.90F;
        const bool fringe = uv.y >= 0.90F && fract(uv.x * 40.0F) < 0.5F &&
                            uv.y < 0.955F + 0.04F * sine(uv.x * 6.0F);
        const bool mesh = uv.y < 0.84F && (strand < 0.14F || knot.x + knot.y < 0.12F || flower);
        if (top_band || low_band || fringe) {
            const float stitch = 0.9F + 0.1F * sine(uv.x * 64.0F);
            return vec4{border * stitch, 1.0F};
        }
        const float light = flower ? 1.0F : 0.88F;
        return vec4{thread * light, mesh ? 1.0F : 0.0F};
    });
}

}  // namespace foverig::builtin
