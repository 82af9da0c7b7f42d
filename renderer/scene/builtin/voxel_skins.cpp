#include "renderer/scene/builtin/voxel_skins.h"

#include <algorithm>
#include <cstdlib>

#include "renderer/scene/builtin/hash.h"

namespace foverig::builtin::voxel {
namespace {

constexpr int kPixels = 16;
constexpr std::uint32_t kTexelsPerPixel = 4;  // keeps pixels crisp under bilinear filtering

/// paint(x, y, random) in block pixels; random is 0..1 and belongs to the pixel.
template <class Paint>
Canvas paint_block(std::uint32_t seed, Paint&& paint) {
    constexpr std::uint32_t kSize = kPixels * kTexelsPerPixel;
    return paint_canvas(kSize, kSize, [&](vec2 uv) {
        const int x = static_cast<int>(uv.x * kPixels);
        const int y = static_cast<int>(uv.y * kPixels);
        return paint(
            x, y,
            unit_of(hash(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), seed)));
    });
}

Canvas speckled(std::uint32_t seed, const vec3& colour, float contrast) {
    return paint_block(seed, [&](int, int, float r) {
        return vec4{colour * (1.0F + contrast * (r - 0.5F)), 1.0F};
    });
}

Canvas grass_side(std::uint32_t seed, const vec3& green, const vec3& earth) {
    return paint_block(seed, [&](int x, int y, float r) {
        const int rim = 3 + static_cast<int>(hash(static_cast<std::uint32_t>(x), seed) % 3U);
        return vec4{(y < rim ? green : earth) * (0.85F + 0.3F * r), 1.0F};
    });
}

Canvas bricks(std::uint32_t seed, const vec3& colour, const vec3& mortar, int width, int height) {
    return paint_block(seed, [=](int x, int y, float r) {
        const int row = y / height;
        const int along = (x + (row % 2) * width / 2) % kPixels;
        const bool joint = y % height == height - 1 || along % width == width - 1;
        const float tone = unit_of(
            hash(static_cast<std::uint32_t>(along / width), static_cast<std::uint32_t>(row), seed));
        return vec4{joint ? mortar * (0.9F + 0.2F * r) : colour * (0.8F + 0.3F * tone + 0.14F * r),
                    1.0F};
    });
}

Canvas cobble(std::uint32_t seed, const vec3& colour) {
    return paint_block(seed, [=](int x, int y, float r) {
        // Nearest of one point in each 4 x 4 cell, wrapped.
        int best = 1000;
        std::uint32_t stone = 0;
        int second = 1000;
        for (int cy = y / 4 - 1; cy <= y / 4 + 1; ++cy) {
            for (int cx = x / 4 - 1; cx <= x / 4 + 1; ++cx) {
                const std::uint32_t id = hash(static_cast<std::uint32_t>(cx & 3),
                                              static_cast<std::uint32_t>(cy & 3), seed);
                const int dx = cx * 4 + static_cast<int>(id % 4U) - x;
                const int dy = cy * 4 + static_cast<int>((id >> 8U) % 4U) - y;
                const int distance = dx * dx + dy * dy;
                if (distance < best) {
                    second = best;
                    best = distance;
                    stone = id;
                } else {
                    second = std::min(second, distance);
                }
            }
        }
        const bool joint = second - best < 3;
        return vec4{colour * (joint ? 0.5F : 0.8F + 0.35F * unit_of(hash(stone)) + 0.1F * r), 1.0F};
    });
}

Canvas planks(std::uint32_t seed, const vec3& colour) {
    return paint_block(seed, [=](int x, int y, float r) {
        const int board = y / 4;
        const bool gap = y % 4 == 3 || x == (board * 7 + 5) % kPixels;
        const float tone = unit_of(hash(static_cast<std::uint32_t>(board), seed));
        return vec4{colour * (gap ? 0.6F : 0.88F + 0.15F * tone + 0.1F * r), 1.0F};
    });
}

Canvas log_side(std::uint32_t seed, const vec3& colour) {
    return paint_block(seed, [=](int x, int, float r) {
        const float stripe = unit_of(hash(static_cast<std::uint32_t>(x), seed));
        return vec4{colour * (0.7F + 0.45F * stripe + 0.15F * r), 1.0F};
    });
}

Canvas log_top(std::uint32_t seed, const vec3& bark, const vec3& wood) {
    return paint_block(seed, [=](int x, int y, float r) {
        const int ring = std::max(std::abs(2 * x - 15), std::abs(2 * y - 15)) / 2;
        return vec4{ring >= 7 ? bark : wood * (ring % 2 == 0 ? 1.0F : 0.84F) * (0.95F + 0.1F * r),
                    1.0F};
    });
}

Canvas roof(std::uint32_t seed, const vec3& colour) {
    return paint_block(seed, [=](int x, int y, float r) {
        const int row = y / 4;
        const int across = (x + (row % 2) * 2) % 4;
        const float shade = (y % 4 == 3 ? 0.62F : 1.0F) * (across == 0 ? 0.78F : 1.0F);
        return vec4{colour * shade * (0.9F + 0.22F * r), 1.0F};
    });
}

Canvas leaves(std::uint32_t seed, const vec3& colour, const vec3& bloom, float bloom_share) {
    return paint_block(seed, [=](int, int, float r) {
        const float other = unit_of(hash(static_cast<std::uint32_t>(r * 16'777'216.0F), seed + 1U));
        const vec3 c = other < bloom_share ? bloom : colour * (0.65F + 0.7F * other);
        return vec4{c, r < 0.26F ? 0.0F : 1.0F};
    });
}

Canvas glass(std::uint32_t seed) {
    return paint_block(seed, [](int x, int y, float) {
        const bool frame = x == 0 || y == 0 || x == 15 || y == 15 || x == 7 || x == 8;
        const bool glint = (x + y == 9 || x + y == 10 || x + y == 24) && x > 1 && y > 1;
        if (frame) return vec4{0.36F, 0.26F, 0.18F, 1.0F};
        return vec4{0.82F, 0.92F, 0.97F, glint ? 1.0F : 0.0F};
    });
}

Canvas tuft(std::uint32_t seed, const vec3& stalk, const vec3& flower, bool flowers) {
    return paint_block(seed, [=](int x, int y, float r) {
        const int height =
            static_cast<int>(hash(static_cast<std::uint32_t>(x), seed) % 9U) + (x % 2) * 4;
        const bool blade = 15 - y < height && (x + y / 4) % 3 != 0;
        const bool head = flowers && std::abs(x - 7) + std::abs(y - 5) < 4;
        const bool stem = flowers && x == 7 && y >= 5;
        if (head) return vec4{flower * (0.8F + 0.3F * r), 1.0F};
        return vec4{stalk * (0.7F + 0.5F * r), blade || stem ? 1.0F : 0.0F};
    });
}

}  // namespace

Skins add_skins(SceneBuilder& builder) {
    Skins skins{};
    const auto put = [&](Block b, std::uint16_t all) {
        skins[static_cast<std::size_t>(b)] = {all, all, all};
    };
    const auto solid = [&](const Canvas& canvas) { return builder.add_textured(canvas); };
    const vec3 green{0.40F, 0.60F, 0.25F};
    const vec3 earth{0.47F, 0.34F, 0.24F};
    const std::uint16_t dirt = solid(speckled(1, earth, 0.35F));
    put(Block::dirt, dirt);
    skins[static_cast<std::size_t>(Block::grass)] = {solid(speckled(2, green, 0.35F)),
                                                     solid(grass_side(3, green, earth)), dirt};
    put(Block::stone, solid(speckled(4, vec3{0.5F}, 0.22F)));
    put(Block::sand, solid(speckled(5, {0.84F, 0.79F, 0.58F}, 0.12F)));
    put(Block::gravel, solid(speckled(6, {0.56F, 0.53F, 0.50F}, 0.4F)));
    Material water;
    water.diffuse = vec3{1.0F};
    water.specular = vec3{0.15F};
    water.shininess = 50.0F;
    water.reflectance = 0.25F;
    water.diffuse_texture = builder.add_texture(speckled(7, {0.20F, 0.36F, 0.62F}, 0.12F));
    put(Block::water, builder.add_material(water));
    const vec3 bark{0.36F, 0.27F, 0.17F};
    const std::uint16_t rings = solid(log_top(9, bark, {0.68F, 0.54F, 0.34F}));
    skins[static_cast<std::size_t>(Block::log)] = {rings, solid(log_side(8, bark)), rings};
    put(Block::planks, solid(planks(10, {0.66F, 0.51F, 0.31F})));
    put(Block::cobble, solid(cobble(11, vec3{0.52F})));
    put(Block::brick, solid(bricks(12, {0.60F, 0.33F, 0.27F}, vec3{0.64F, 0.6F, 0.56F}, 8, 4)));
    put(Block::plaster, solid(speckled(13, {0.90F, 0.87F, 0.79F}, 0.06F)));
    put(Block::ochre, solid(speckled(14, {0.85F, 0.67F, 0.38F}, 0.07F)));
    put(Block::rose, solid(speckled(15, {0.78F, 0.52F, 0.44F}, 0.07F)));
    put(Block::tiles, solid(roof(16, {0.67F, 0.28F, 0.19F})));
    put(Block::slate, solid(roof(17, {0.31F, 0.35F, 0.42F})));
    put(Block::ashlar, solid(bricks(18, {0.68F, 0.66F, 0.61F}, vec3{0.5F, 0.48F, 0.45F}, 16, 8)));
    put(Block::hay, solid(log_side(19, {0.80F, 0.66F, 0.22F})));
    put(Block::red_wool, solid(speckled(20, {0.68F, 0.16F, 0.15F}, 0.12F)));
    put(Block::white_wool, solid(speckled(21, {0.90F, 0.90F, 0.88F}, 0.08F)));
    Material lamp;
    lamp.diffuse = vec3{0.2F};
    lamp.emission = {0.95F, 0.8F, 0.5F};
    lamp.emission_texture = builder.add_texture(cobble(22, {1.0F, 0.86F, 0.55F}));
    put(Block::lamp, builder.add_material(lamp));
    put(Block::leaves, builder.add_cut_out(leaves(23, {0.27F, 0.46F, 0.17F}, vec3{0.0F}, 0.0F)));
    put(Block::blossom,
        builder.add_cut_out(leaves(24, {0.36F, 0.48F, 0.20F}, {0.92F, 0.62F, 0.70F}, 0.55F)));
    put(Block::glass, builder.add_cut_out(glass(25)));
    return skins;
}

Tufts add_tufts(SceneBuilder& builder) {
    const vec3 stalk{0.38F, 0.58F, 0.22F};
    return {builder.add_cut_out(tuft(30, stalk, stalk, false)),
            builder.add_cut_out(tuft(31, stalk, {0.82F, 0.18F, 0.14F}, true)),
            builder.add_cut_out(tuft(32, stalk, {0.94F, 0.82F, 0.2F}, true))};
}

}  // namespace foverig::builtin::voxel
