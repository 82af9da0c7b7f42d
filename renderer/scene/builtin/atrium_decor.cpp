#include <array>

#include "renderer/scene/builtin/atrium_plan.h"
#include "renderer/scene/builtin/grid.h"
#include "renderer/scene/builtin/hash.h"
#include "renderer/scene/builtin/noise.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

namespace foverig::builtin::atrium {
namespace {

constexpr float kRod_m = kSpring_m - 0.2F;
constexpr float kOpening_m = kBay_m - 0.6F;

/// One drape from `from_m` to `to_m`, drawn aside to its outer edge at `tie` of its height.
void add_drape(Mesh& mesh, std::uint16_t cloth, float from_m, float to_m, double detail,
               std::uint32_t seed) {
    const float width_m = std::fabs(to_m - from_m);
    const float low_m = 0.12F;
    const auto point = [&](float u, float v) {
        const float tied = smoothstep(0.0F, 0.62F, v) * (1.0F - 0.55F * smoothstep(0.62F, 0.8F, v));
        const float drawn = 1.0F - 0.74F * tied;
        const float depth = 0.04F + 0.035F * v - 0.015F * tied;
        const float wave = sine(5.0F * u + 0.25F * noise(vec3{u * 3.0F, v * 2.0F, 0.5F}, seed));
        const float sway = 0.03F * noise(vec3{u * 2.0F, v * 3.0F, 7.5F}, seed + 1U);
        const float hem = 0.03F * wave * v;
        return vec3{from_m + (to_m - from_m) * u * drawn, mix(kRod_m, low_m + hem, v),
                    depth * wave + sway};
    };
    // Faces the court whichever way it is drawn.
    const bool mirrored = to_m < from_m;
    const auto facing = [&](float u, float v) { return point(mirrored ? 1.0F - u : u, 1.0F - v); };
    add_grid(mesh, cloth, finer(42, detail, 14), finer(15, detail, 6), false, facing,
             [&](float u, float v) {
                 return vec2{(mirrored ? 1.0F - u : u) * width_m * 1.2F,
                             (1.0F - v) * (kRod_m - low_m) * 0.65F};
             });
}

void add_closed_sheet(Mesh& mesh, std::uint16_t lace, double detail, std::uint32_t seed) {
    const float low_m = 0.2F;
    const auto point = [&](float u, float v) {
        const float wave = sine(9.0F * u + 0.3F * noise(vec3{u * 4.0F, v * 2.0F, 1.5F}, seed));
        return vec3{(u - 0.5F) * kOpening_m, mix(low_m, kRod_m, v),
                    (0.03F + 0.04F * (1.0F - v)) * wave};
    };
    add_grid(mesh, lace, finer(54, detail, 18), finer(8, detail, 4), false, point,
             [](float u, float v) {
                 return vec2{2.0F * u, 1.0F - v};
             });
}

}  // namespace

Mesh make_curtain(const Paints& paints, Hanging hanging, double detail, std::uint32_t seed) {
    Mesh mesh;
    const float edge_m = 0.5F * kOpening_m;
    if (hanging == Hanging::lace) {
        add_closed_sheet(mesh, paints.lace, detail, seed);
        return mesh;
    }
    const std::uint16_t cloth = hanging == Hanging::red     ? paints.red_cloth
                                : hanging == Hanging::green ? paints.green_cloth
                                                            : paints.blue_cloth;
    add_drape(mesh, cloth, -edge_m, -0.02F, detail, seed);
    add_drape(mesh, cloth, edge_m, 0.02F, detail, seed + 7U);
    return mesh;
}

Mesh make_banner(const Paints& paints, double detail, std::uint32_t seed) {
    Mesh mesh;
    constexpr float kHalf_m = 0.55F;
    const float low_m = kSpring_m + 0.55F;
    const auto point = [&](float u, float v) {
        const float billow =
            0.06F * (1.0F - v) * (1.0F + noise(vec3{u * 2.0F, v * 2.0F, 0.5F}, seed));
        const float clear = kWallHalf_m + 0.3F * smoothstep(1.0F, 0.86F, v);
        return vec3{(u - 0.5F) * 2.0F * kHalf_m, mix(low_m, kRail_m + 0.01F, v),
                    (v > 0.999F ? 0.15F : clear) + billow + 0.02F * sine(2.5F * u) * (1.0F - v)};
    };
    add_grid(mesh, paints.pennant, finer(10, detail, 6), finer(16, detail, 8), false, point,
             [](float u, float v) {
                 return vec2{u, 1.0F - v};
             });
    return mesh;
}

Mesh make_lantern(const Paints& paints) {
    Mesh mesh;
    const float hang_m = kSpring_m - 0.6F;
    add_box(mesh, paints.iron, {-0.012F, hang_m + 0.3F, -0.012F},
            {0.012F, kSpring_m + 1.24F, 0.012F}, kSides);
    constexpr std::array<vec2, 4> kGlass{vec2{0.0F, 0.0F}, vec2{0.1F, 0.0F}, vec2{0.13F, 0.26F},
                                         vec2{0.0F, 0.26F}};
    add_lathe(mesh, {paints.glow}, kGlass, 6, {0.0F, hang_m, 0.0F});
    constexpr std::array<vec2, 5> kHood{vec2{0.0F, 0.26F}, vec2{0.18F, 0.26F}, vec2{0.18F, 0.28F},
                                        vec2{0.05F, 0.38F}, vec2{0.0F, 0.38F}};
    add_lathe(mesh, paints.iron, kHood, 6, {0.0F, hang_m, 0.0F});
    for (int i = 0; i < 6; ++i) {
        Mesh bar;
        add_box(bar, paints.iron, {0.105F, hang_m - 0.02F, -0.01F},
                {0.135F, hang_m + 0.27F, 0.01F});
        mesh.append(bar, {vec3{0.0F}, static_cast<float>(i) / 6.0F});
    }
    add_blob(mesh, paints.iron, {0.0F, hang_m - 0.03F, 0.0F}, {0.11F, 0.03F, 0.11F}, 8);
    return mesh;
}

Mesh make_fountain(const Paints& paints, double detail) {
    Mesh mesh;
    constexpr std::array<vec2, 13> kBasin{vec2{1.75F, 0.0F},  vec2{1.75F, 0.14F}, vec2{1.6F, 0.14F},
                                          vec2{1.55F, 0.2F},  vec2{1.5F, 0.42F},  vec2{1.62F, 0.5F},
                                          vec2{1.66F, 0.56F}, vec2{1.62F, 0.6F},  vec2{1.42F, 0.6F},
                                          vec2{1.4F, 0.54F},  vec2{1.38F, 0.3F},  vec2{1.3F, 0.16F},
                                          vec2{0.0F, 0.16F}};
    add_lathe(mesh, paints.pale_stone, kBasin, 8);
    constexpr std::array<vec2, 16> kBowl{
        vec2{0.42F, 0.16F}, vec2{0.42F, 0.3F},  vec2{0.28F, 0.36F}, vec2{0.17F, 0.5F},
        vec2{0.15F, 0.75F}, vec2{0.22F, 0.95F}, vec2{0.16F, 1.05F}, vec2{0.16F, 1.15F},
        vec2{0.45F, 1.28F}, vec2{0.72F, 1.46F}, vec2{0.78F, 1.52F}, vec2{0.76F, 1.56F},
        vec2{0.7F, 1.55F},  vec2{0.5F, 1.43F},  vec2{0.2F, 1.36F},  vec2{0.0F, 1.36F}};
    const int segments = finer(40, detail, 10);
    add_lathe(mesh, paints.pale_stone, kBowl, segments);
    constexpr std::array<vec2, 8> kFinial{
        vec2{0.12F, 1.36F}, vec2{0.09F, 1.6F},  vec2{0.13F, 1.68F}, vec2{0.16F, 1.76F},
        vec2{0.13F, 1.86F}, vec2{0.06F, 1.92F}, vec2{0.09F, 2.0F},  vec2{0.0F, 2.1F}};
    add_lathe(mesh, paints.pale_stone, kFinial, segments / 2);
    const auto water = [&](float radius_m, float level_m, int sides) {
        const std::array<vec2, 2> disc{vec2{radius_m, level_m}, vec2{0.0F, level_m}};
        add_lathe(mesh, {paints.water}, disc, sides);
    };
    water(1.385F, 0.45F, 8);
    water(0.64F, 1.5F, segments);
    return mesh;
}

Mesh make_pot(const Paints& paints, double detail) {
    Mesh mesh;
    constexpr std::array<vec2, 11> kPot{vec2{0.2F, 0.0F},   vec2{0.2F, 0.05F},  vec2{0.17F, 0.08F},
                                        vec2{0.26F, 0.3F},  vec2{0.31F, 0.48F}, vec2{0.31F, 0.52F},
                                        vec2{0.35F, 0.54F}, vec2{0.35F, 0.6F},  vec2{0.29F, 0.6F},
                                        vec2{0.28F, 0.5F},  vec2{0.0F, 0.5F}};
    add_lathe(mesh, paints.terracotta, kPot, finer(20, detail, 8));
    return mesh;
}

}  // namespace foverig::builtin::atrium
