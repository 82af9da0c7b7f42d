#include "renderer/scene/textures.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "renderer/scene/import_error.h"

namespace foverig::scene_import {
namespace {

struct SrgbTables {
    std::array<float, 256> linear{};
    std::vector<std::uint8_t> srgb = std::vector<std::uint8_t>(65536);  ///< by linear * 65535

    SrgbTables() {
        const auto to_linear = [](double s) {
            return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
        };
        for (std::size_t i = 0; i < 256; ++i)
            linear[i] = static_cast<float>(to_linear(static_cast<double>(i) / 255.0));
        std::size_t code = 0;
        for (std::size_t i = 0; i < srgb.size(); ++i) {
            const double value = static_cast<double>(i) / 65535.0;
            while (code < 255 && to_linear((static_cast<double>(code) + 0.5) / 255.0) <= value)
                ++code;
            srgb[i] = static_cast<std::uint8_t>(code);
        }
    }
};

const SrgbTables& srgb_tables() {
    static const SrgbTables tables;
    return tables;
}

/// Up to three source rows or columns under one destination texel, with their shares.
struct Footprint {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::array<float, 4> share{};
};

std::vector<Footprint> footprints(std::uint32_t from, std::uint32_t to) {
    std::vector<Footprint> result(to);
    const double scale = static_cast<double>(from) / to;
    for (std::uint32_t i = 0; i < to; ++i) {
        const double begin = i * scale;
        const double end = std::min<double>(from, begin + scale);
        Footprint& f = result[i];
        f.first = static_cast<std::uint32_t>(begin);
        for (std::uint32_t s = f.first; s < end && f.count < f.share.size(); ++s)
            f.share[f.count++] = static_cast<float>(
                (std::min<double>(s + 1, end) - std::max<double>(s, begin)) / scale);
    }
    return result;
}

std::uint32_t average(const std::uint32_t* texels, std::uint32_t width, const Footprint& column,
                      const Footprint& row) {
    const SrgbTables& tables = srgb_tables();
    vec3 weighted{0.0F};
    vec3 plain{0.0F};
    float alpha = 0.0F;
    for (std::uint32_t y = 0; y < row.count; ++y) {
        const std::uint32_t* line = texels + std::size_t{row.first + y} * width + column.first;
        for (std::uint32_t x = 0; x < column.count; ++x) {
            const std::uint32_t c = line[x];
            const float share = row.share[y] * column.share[x];
            const vec3 colour{tables.linear[c & 255U], tables.linear[(c >> 8U) & 255U],
                              tables.linear[(c >> 16U) & 255U]};
            const float covered = share * static_cast<float>(c >> 24U);
            weighted += covered * colour;
            plain += share * colour;
            alpha += covered;
        }
    }
    const vec3 colour = alpha > 0.0F ? weighted * (1.0F / alpha) : plain;
    const auto code = [&](float value) {
        return std::uint32_t{
            tables.srgb[static_cast<std::size_t>(std::clamp(value, 0.0F, 1.0F) * 65535.0F + 0.5F)]};
    };
    const auto coverage = static_cast<std::uint32_t>(std::clamp(alpha + 0.5F, 0.0F, 255.0F));
    return code(colour.x) | code(colour.y) << 8U | code(colour.z) << 16U | coverage << 24U;
}

/// Appends the level below `texels[first..]`, which is width x height.
void append_level(std::vector<std::uint32_t>& texels, std::size_t first, std::uint32_t width,
                  std::uint32_t height) {
    const std::vector<Footprint> columns = footprints(width, std::max(1U, width >> 1U));
    const std::vector<Footprint> rows = footprints(height, std::max(1U, height >> 1U));
    const std::size_t begin = texels.size();
    texels.resize(begin + columns.size() * rows.size());
    std::uint32_t* out = texels.data() + begin;
    for (const Footprint& row : rows)
        for (const Footprint& column : columns)
            *out++ = average(texels.data() + first, width, column, row);
}

}  // namespace

std::int32_t append_texture(ImportedScene& imported, const RgbaImage& image, const TextureUse& use,
                            const ImportContext& context) {
    std::vector<std::uint32_t>& texels = imported.scene.texels;
    if (texels.size() + image.pixels.size() * 3 / 2 > std::numeric_limits<std::uint32_t>::max())
        fail(context.file, "its textures hold more than 2^32 texels; scale its images down");
    Texture texture;
    texture.width = image.width;
    texture.height = image.height;
    texture.level_count =
        static_cast<std::uint32_t>(std::bit_width(std::max(image.width, image.height)));
    texture.first_texel = static_cast<std::uint32_t>(texels.size());
    texture.repeat_u = use.repeat_u;
    texture.repeat_v = use.repeat_v;

    texels.insert(texels.end(), image.pixels.begin(), image.pixels.end());
    const auto level_0 = texels.end() - static_cast<std::ptrdiff_t>(image.pixels.size());
    if (!use.alpha)
        std::for_each(level_0, texels.end(), [](std::uint32_t& texel) { texel |= 0xFF000000U; });
    texture.has_alpha =
        std::any_of(level_0, texels.end(), [](std::uint32_t texel) { return texel >> 24U < 255U; });

    std::size_t first = texture.first_texel;
    std::uint32_t width = image.width;
    std::uint32_t height = image.height;
    for (std::uint32_t level = 1; level < texture.level_count; ++level) {
        const std::size_t next = texels.size();
        append_level(texels, first, width, height);
        first = next;
        width = std::max(1U, width >> 1U);
        height = std::max(1U, height >> 1U);
    }
    imported.scene.textures.push_back(texture);
    return static_cast<std::int32_t>(imported.scene.textures.size() - 1);
}

RgbaImage with_alpha_of(RgbaImage colour, const RgbaImage& mask) {
    // A mask finer than the colour keeps its detail: the colour is what gets repeated.
    if (mask.width > colour.width || mask.height > colour.height) {
        RgbaImage fine{
            std::max(mask.width, colour.width), std::max(mask.height, colour.height), false, {}};
        fine.pixels.resize(std::size_t{fine.width} * fine.height);
        for (std::uint32_t y = 0; y < fine.height; ++y)
            for (std::uint32_t x = 0; x < fine.width; ++x)
                fine.pixels[std::size_t{y} * fine.width + x] =
                    colour.pixels[std::size_t{y} * colour.height / fine.height * colour.width +
                                  std::size_t{x} * colour.width / fine.width];
        colour = std::move(fine);
    }
    for (std::uint32_t y = 0; y < colour.height; ++y) {
        for (std::uint32_t x = 0; x < colour.width; ++x) {
            const std::uint32_t m =
                mask.pixels[std::size_t{y} * mask.height / colour.height * mask.width +
                            std::size_t{x} * mask.width / colour.width];
            const std::uint32_t luminance =
                ((m & 255U) * 54U + ((m >> 8U) & 255U) * 183U + ((m >> 16U) & 255U) * 19U) >> 8U;
            const std::uint32_t alpha = mask.has_alpha_channel ? m >> 24U : luminance;
            std::uint32_t& texel = colour.pixels[std::size_t{y} * colour.width + x];
            texel = (texel & 0x00FFFFFFU) | alpha << 24U;
        }
    }
    colour.has_alpha_channel = true;
    return colour;
}

}  // namespace foverig::scene_import
