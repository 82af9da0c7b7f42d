#pragma once
// Trilinear lookups in mip-mapped RGBA8 sRGB textures.
#include <cmath>

#include "renderer/math.h"
#include "renderer/scene/scene_view.h"

namespace foverig {

RIG_INLINE int wrap_texel(int i, int n, bool repeat) {
    if (!repeat) return i < 0 ? 0 : (i >= n ? n - 1 : i);
    const int r = i % n;
    return r < 0 ? r + n : r;
}

/// Power-of-two sizes wrap by a mask; nearly all textures have them.
RIG_INLINE int wrap_fast(int i, int n, bool repeat) {
    return repeat && (n & (n - 1)) == 0 ? i & (n - 1) : wrap_texel(i, n, repeat);
}

/// Bilinear linear RGB and alpha of one level at uv in [0,1] (v from the top).
RIG_INLINE Quad sample_level(const SceneView& scene, const Texture& texture, const MipLevel& mip,
                             float u, float v) {
    const float x = u * static_cast<float>(mip.width) - 0.5F;
    const float y = v * static_cast<float>(mip.height) - 0.5F;
    const float fx = std::floor(x);
    const float fy = std::floor(y);
    const int x0 = wrap_fast(static_cast<int>(fx), mip.width, texture.repeat_u);
    const int x1 = wrap_fast(static_cast<int>(fx) + 1, mip.width, texture.repeat_u);
    const int y0 = wrap_fast(static_cast<int>(fy), mip.height, texture.repeat_v);
    const int y1 = wrap_fast(static_cast<int>(fy) + 1, mip.height, texture.repeat_v);
    const float wx = x - fx;
    const float wy = y - fy;
    const Half4* const top = scene.linear_texels.data + mip.first + y0 * mip.width;
    const Half4* const bottom = scene.linear_texels.data + mip.first + y1 * mip.width;
    const Quad upper = unpack_quad(top[x0]) * (1.0F - wx) + unpack_quad(top[x1]) * wx;
    const Quad lower = unpack_quad(bottom[x0]) * (1.0F - wx) + unpack_quad(bottom[x1]) * wx;
    return upper * (1.0F - wy) + lower * wy;
}

/// The part of uv that wrapping keeps, so that a large uv loses no bits in the multiplication.
RIG_INLINE float wrapped(float u, bool repeat) {
    return repeat ? u - std::floor(u) : clamp_to(u, 0.0F, 1.0F);
}

/// Texture `index` of the scene; `lod` is log2 of the footprint's width in texels of level 0.
RIG_INLINE vec4 sample_texture(const SceneView& scene, std::int32_t index, vec2 uv, float lod) {
    const Texture& texture = scene.textures[static_cast<std::size_t>(index)];
    const float u = wrapped(uv.x, texture.repeat_u);
    const float v = wrapped(uv.y, texture.repeat_v);
    const float clamped = clamp_to(lod, 0.0F, static_cast<float>(texture.level_count - 1));
    const int level = static_cast<int>(clamped);
    const float blend = clamped - static_cast<float>(level);
    const MipLevel* const mips =
        scene.mips.data + static_cast<std::uint32_t>(index) * kMostLevels + level;
    const Quad fine = sample_level(scene, texture, mips[0], u, v);
    if (blend <= 0.0F) return to_vec4(fine);
    return to_vec4(fine * (1.0F - blend) + sample_level(scene, texture, mips[1], u, v) * blend);
}

/// Alpha alone, nearest texel of level 0: what the any-hit test asks.
RIG_INLINE float sample_alpha(const SceneView& scene, const Texture& texture, vec2 uv) {
    const int width = static_cast<int>(texture.width);
    const int height = static_cast<int>(texture.height);
    const int x =
        wrap_fast(static_cast<int>(wrapped(uv.x, texture.repeat_u) * static_cast<float>(width)),
                  width, texture.repeat_u);
    const int y =
        wrap_fast(static_cast<int>(wrapped(uv.y, texture.repeat_v) * static_cast<float>(height)),
                  height, texture.repeat_v);
    return static_cast<float>(
               scene.texels[texture.first_texel + static_cast<std::uint32_t>(y * width + x)] >>
               24U) *
           (1.0F / 255.0F);
}

}  // namespace foverig
