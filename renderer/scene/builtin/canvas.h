#pragma once
// Textures in the making. Painters think in sRGB, as the texture stores it.
#include <cstdint>
#include <vector>

#include "renderer/scene/builtin/exact.h"
#include "renderer/scene/scene.h"

namespace foverig::builtin {

/// RGBA8 sRGB, rows from the top; sides are powers of two.
struct Canvas {
    std::uint32_t width_px = 1;
    std::uint32_t height_px = 1;
    std::vector<std::uint32_t> texels;
};

/// Channels are clamped to [0, 1].
std::uint32_t pack_rgba8(const vec3& srgb, float alpha = 1.0F);

/// Calls paint(uv) for every texel centre; it returns sRGB as vec3, or vec4 with alpha.
template <class Paint>
Canvas paint_canvas(std::uint32_t width_px, std::uint32_t height_px, Paint&& paint) {
    Canvas canvas{width_px, height_px, {}};
    canvas.texels.reserve(static_cast<std::size_t>(width_px) * height_px);
    for (std::uint32_t y = 0; y < height_px; ++y) {
        for (std::uint32_t x = 0; x < width_px; ++x) {
            const vec4 c{
                paint(vec2{(static_cast<float>(x) + 0.5F) / static_cast<float>(width_px),
                           (static_cast<float>(y) + 0.5F) / static_cast<float>(height_px)})};
            canvas.texels.push_back(pack_rgba8(vec3{c}, c.w));
        }
    }
    return canvas;
}

/// Appends the canvas and its mip chain down to 1 x 1 to `texels`. Colours are averaged in linear
/// light, weighted by alpha, so that what shows at the rim of a hole has the cloth's colour.
Texture append_mip_chain(std::vector<std::uint32_t>& texels, const Canvas& canvas);

}  // namespace foverig::builtin
