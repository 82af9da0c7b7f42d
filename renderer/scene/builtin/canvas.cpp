#include "renderer/scene/builtin/canvas.h"

#include <algorithm>
#include <array>

namespace foverig::builtin {
namespace {

struct Codec {
    std::array<float, 256> linear_of;
    std::array<std::uint8_t, 4096> code_of;  ///< by linear value * 4095

    Codec() {
        for (std::size_t i = 0; i < 256; ++i)
            linear_of[i] = linear_of_srgb(static_cast<float>(i) / 255.0F);
        std::size_t code = 0;
        for (std::size_t i = 0; i < code_of.size(); ++i) {
            const float linear = static_cast<float>(i) / 4095.0F;
            while (code < 255 && linear - linear_of[code] > linear_of[code + 1] - linear) ++code;
            code_of[i] = static_cast<std::uint8_t>(code);
        }
    }
    std::uint32_t code(float linear) const {
        return code_of[static_cast<std::size_t>(clamp(linear, 0.0F, 1.0F) * 4095.0F + 0.5F)];
    }
};

std::uint32_t mean_texel(const std::array<std::uint32_t, 4>& texels, const Codec& codec) {
    vec3 weighted{0.0F};
    vec3 plain{0.0F};
    std::uint32_t alpha_sum = 0;
    for (const std::uint32_t t : texels) {
        const vec3 colour{codec.linear_of[t & 255U], codec.linear_of[(t >> 8U) & 255U],
                          codec.linear_of[(t >> 16U) & 255U]};
        weighted += colour * static_cast<float>(t >> 24U);
        plain += colour;
        alpha_sum += t >> 24U;
    }
    const vec3 c = alpha_sum > 0 ? weighted / static_cast<float>(alpha_sum) : plain * 0.25F;
    return codec.code(c.x) | codec.code(c.y) << 8U | codec.code(c.z) << 16U |
           ((alpha_sum + 2U) / 4U) << 24U;
}

}  // namespace

std::uint32_t pack_rgba8(const vec3& srgb, float alpha) {
    const auto byte = [](float x) {
        return static_cast<std::uint32_t>(clamp(x, 0.0F, 1.0F) * 255.0F + 0.5F);
    };
    return byte(srgb.x) | byte(srgb.y) << 8U | byte(srgb.z) << 16U | byte(alpha) << 24U;
}

Texture append_mip_chain(std::vector<std::uint32_t>& texels, const Canvas& canvas) {
    const Codec codec;
    Texture texture;
    texture.width = canvas.width_px;
    texture.height = canvas.height_px;
    texture.first_texel = static_cast<std::uint32_t>(texels.size());
    texture.has_alpha = std::any_of(canvas.texels.begin(), canvas.texels.end(),
                                    [](std::uint32_t t) { return (t >> 24U) < 255U; });
    texels.insert(texels.end(), canvas.texels.begin(), canvas.texels.end());
    std::uint32_t w = canvas.width_px;
    std::uint32_t h = canvas.height_px;
    std::size_t from = texture.first_texel;
    while (w > 1 || h > 1) {
        const std::uint32_t half_w = std::max(1U, w / 2U);
        const std::uint32_t half_h = std::max(1U, h / 2U);
        for (std::uint32_t y = 0; y < half_h; ++y) {
            for (std::uint32_t x = 0; x < half_w; ++x) {
                const auto at = [&](std::uint32_t dx, std::uint32_t dy) {
                    const std::size_t sx = std::min(2 * x + dx, w - 1);
                    const std::size_t sy = std::min(2 * y + dy, h - 1);
                    return texels[from + sy * w + sx];
                };
                texels.push_back(mean_texel({at(0, 0), at(1, 0), at(0, 1), at(1, 1)}, codec));
            }
        }
        from += static_cast<std::size_t>(w) * h;
        w = half_w;
        h = half_h;
        ++texture.level_count;
    }
    return texture;
}

}  // namespace foverig::builtin
