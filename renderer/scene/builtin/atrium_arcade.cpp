#include <array>

#include "renderer/scene/builtin/atrium_plan.h"
#include "renderer/scene/builtin/grid.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

namespace foverig::builtin::atrium {
namespace {

constexpr float kHalfBay_m = 0.5F * kBay_m;

struct Arch {
    float spring_m;
    float radius_m;
    float top_m;
};
constexpr Arch kGroundArch{kSpring_m, kHalfBay_m - 0.3F, kUpperFloor_m - 0.35F};
constexpr Arch kUpperArch{kUpperSpring_m, kHalfBay_m - 0.22F, kEaves_m - 0.3F};

/// A centred square block.
void add_block(Mesh& mesh, Surface surface, float half_m, float low_m, float high_m) {
    add_box(mesh, surface, {-half_m, low_m, -half_m}, {half_m, high_m, half_m});
}

/// Shaft that swells by a third of its taper (entasis), with a moulded base and a bell capital.
void add_shaft(Mesh& mesh, Surface surface, float low_m, float high_m, float radius_m,
               int segments) {
    std::vector<vec2> profile;
    const float r = radius_m;
    for (int i = 0; i <= 4; ++i) {
        const float a = -0.25F + 0.125F * static_cast<float>(i);
        profile.emplace_back(r * (1.22F + 0.14F * cosine(a)),
                             low_m + r * (0.16F + 0.16F * sine(a)));
    }
    profile.emplace_back(r * 1.12F, low_m + r * 0.36F);
    profile.emplace_back(r * 1.05F, low_m + r * 0.52F);
    const float foot_m = low_m + r * 0.62F;
    const float neck_m = high_m - r * 1.5F;
    constexpr int kRings = 6;
    for (int i = 0; i <= kRings; ++i) {
        const float t = static_cast<float>(i) / kRings;
        const float swell = 1.0F - 0.17F * t * t + 0.02F * sine(0.5F * t);
        profile.emplace_back(r * swell, mix(foot_m, neck_m, t));
    }
    profile.emplace_back(r * 0.95F, neck_m + r * 0.04F);
    profile.emplace_back(r * 0.95F, neck_m + r * 0.18F);
    profile.emplace_back(r * 0.84F, neck_m + r * 0.24F);
    for (int i = 0; i <= 5; ++i) {
        const float t = static_cast<float>(i) / 5.0F;
        profile.emplace_back(r * (0.84F + 0.48F * t * t), neck_m + r * (0.3F + 1.0F * t));
    }
    profile.emplace_back(r * 1.36F, high_m);
    add_lathe(mesh, surface, profile, segments);
}

/// Leaves of the capital: small curled tongues around the bell.
void add_capital_leaves(Mesh& mesh, Surface surface, float high_m, float radius_m) {
    for (int i = 0; i < 8; ++i) {
        const float turns = static_cast<float>(i) / 8.0F;
        Mesh leaf;
        add_grid(
            leaf, surface.material, 2, 4, false,
            [&](float u, float v) {
                const float half = radius_m * 0.32F * (1.0F - 0.6F * v * v);
                const float curl = radius_m * (0.88F + 0.55F * v * v + 0.12F * sine(0.5F * u));
                return vec3{(u - 0.5F) * 2.0F * half,
                            high_m - radius_m * (1.3F - 1.0F * v + 0.25F * v * v * v), curl};
            },
            [](float u, float v) {
                return vec2{u, -v} * 0.2F;
            });
        mesh.append(leaf, {vec3{0.0F}, turns});
    }
}

/// The wall over an arch, its soffit, and a moulding on the court's side.
void add_arch(Mesh& mesh, Surface wall, Surface trim, const Arch& arch, int segments) {
    const float r = arch.radius_m;
    const auto on_arch = [&](float u, float radius) {
        return vec2{-radius * cosine(0.5F * u), arch.spring_m + radius * sine(0.5F * u)};
    };
    for (const float side : {1.0F, -1.0F}) {
        const vec3 normal{0.0F, 0.0F, side};
        const float z = side * kWallHalf_m;
        const auto face = [&](float u, float v) {
            const vec2 low = on_arch(side > 0.0F ? u : 1.0F - u, r);
            return vec3{low.x, mix(low.y, arch.top_m, v), z};
        };
        add_grid(mesh, wall.material, segments, 1, false, face,
                 [&](float u, float v) { return box_mapped(face(u, v), normal, wall.period_m); });
        const float rest = kHalfBay_m - r;
        for (const float left : {-kHalfBay_m, r}) {
            const vec3 width{side * rest, 0.0F, 0.0F};
            add_quad(mesh, wall, {side > 0.0F ? left : left + rest, arch.spring_m, z}, width,
                     {0.0F, arch.top_m - arch.spring_m, 0.0F});
        }
    }
    const auto soffit = [&](float u, float v) {
        const vec2 p = on_arch(u, r);
        return vec3{p.x, p.y, mix(kWallHalf_m + 0.04F, -kWallHalf_m, v)};
    };
    add_grid(mesh, trim.material, segments, 1, false, soffit, [&](float u, float v) {
        return vec2{u * 3.0F * r, v * 0.5F} / trim.period_m;
    });
    const float front_m = kWallHalf_m + 0.04F;
    const auto ring = [&](float u, float v) {
        const vec2 p = on_arch(u, mix(r, r + 0.2F, v));
        return vec3{p.x, p.y, front_m};
    };
    add_grid(mesh, trim.material, segments, 1, false, ring, [&](float u, float v) {
        return vec2{u * 3.0F * r, v * 0.2F} / trim.period_m;
    });
    const auto rim = [&](float u, float v) {
        const vec2 p = on_arch(u, r + 0.2F);
        return vec3{p.x, p.y, mix(front_m, kWallHalf_m, v)};
    };
    add_grid(mesh, trim.material, segments, 1, false, rim, [&](float u, float v) {
        return vec2{u * 3.0F * r, v * 0.1F} / trim.period_m;
    });
    add_box(mesh, trim, {-0.11F, arch.spring_m + r - 0.02F, front_m - 0.02F},
            {0.11F, arch.spring_m + r + 0.27F, front_m + 0.05F});
}

/// Stepped band along the bay, on the court's side, with dentils below.
void add_cornice(Mesh& mesh, Surface surface, float low_m, float high_m) {
    const float step = (high_m - low_m) / 3.0F;
    for (int i = 0; i < 3; ++i) {
        const float out = kWallHalf_m + 0.06F + 0.07F * static_cast<float>(i);
        const float y = low_m + step * static_cast<float>(i);
        add_box(mesh, surface, {-kHalfBay_m, y, -kWallHalf_m}, {kHalfBay_m, y + step, out},
                kBottom | kTop | kFront | (i == 0 ? kBack : 0U));
    }
    constexpr int kDentils = 14;
    const float pitch = kBay_m / kDentils;
    for (int i = 0; i < kDentils; ++i) {
        const float x = -kHalfBay_m + pitch * (static_cast<float>(i) + 0.25F);
        add_box(mesh, surface, {x, low_m - 0.1F, kWallHalf_m - 0.01F},
                {x + 0.5F * pitch, low_m, kWallHalf_m + 0.06F}, kAllFaces & ~(kTop | kBack));
    }
}

}  // namespace

Mesh make_column(const Paints& paints, double detail) {
    Mesh mesh;
    add_block(mesh, paints.pale_stone, 0.34F, 0.0F, 0.16F);
    add_shaft(mesh, paints.pale_stone, 0.16F, kSpring_m - 0.12F, 0.245F, finer(18, detail, 8));
    add_capital_leaves(mesh, paints.pale_stone, kSpring_m - 0.12F, 0.245F);
    add_block(mesh, paints.pale_stone, 0.36F, kSpring_m - 0.12F, kSpring_m);
    return mesh;
}

Mesh make_upper_column(const Paints& paints, double detail) {
    Mesh mesh;
    add_block(mesh, paints.pale_stone, 0.24F, kUpperFloor_m, kRail_m - 0.08F);
    add_block(mesh, paints.pale_stone, 0.27F, kRail_m - 0.08F, kRail_m);
    add_shaft(mesh, paints.pale_stone, kRail_m, kUpperSpring_m - 0.1F, 0.155F,
              finer(13, detail, 6));
    add_block(mesh, paints.pale_stone, 0.27F, kUpperSpring_m - 0.1F, kUpperSpring_m);
    return mesh;
}

Mesh make_corner_pier(const Paints& paints) {
    Mesh mesh;
    add_block(mesh, paints.stone, 0.44F, 0.0F, 0.3F);
    add_block(mesh, paints.stone, 0.36F, 0.3F, kSpring_m - 0.12F);
    add_block(mesh, paints.pale_stone, 0.42F, kSpring_m - 0.12F, kSpring_m + 0.04F);
    add_block(mesh, paints.stone, 0.32F, kSpring_m + 0.04F, kUpperFloor_m - 0.2F);
    add_block(mesh, paints.stone, 0.32F, kUpperFloor_m, kUpperSpring_m - 0.1F);
    add_block(mesh, paints.pale_stone, 0.36F, kUpperSpring_m - 0.1F, kUpperSpring_m + 0.04F);
    add_block(mesh, paints.stone, 0.3F, kUpperSpring_m + 0.04F, kEaves_m - 0.1F);
    return mesh;
}

Mesh make_arcade_bay(const Paints& paints, double detail) {
    Mesh mesh;
    const int segments = finer(20, detail, 6);
    add_arch(mesh, paints.stone, paints.pale_stone, kGroundArch, segments);
    add_cornice(mesh, paints.pale_stone, kGroundArch.top_m, kUpperFloor_m);
    add_arch(mesh, paints.plaster, paints.pale_stone, kUpperArch, segments);
    add_cornice(mesh, paints.pale_stone, kUpperArch.top_m, kEaves_m);
    return mesh;
}

Mesh make_balustrade(const Paints& paints, double detail) {
    Mesh mesh;
    constexpr std::array<vec2, 9> kBaluster{
        vec2{0.075F, 0.0F},  vec2{0.075F, 0.06F}, vec2{0.045F, 0.1F},
        vec2{0.082F, 0.24F}, vec2{0.082F, 0.31F}, vec2{0.038F, 0.54F},
        vec2{0.038F, 0.6F},  vec2{0.07F, 0.66F},  vec2{0.07F, 0.71F}};
    constexpr int kBalusters = 8;
    const float span = kBay_m - 0.5F;
    for (int i = 0; i < kBalusters; ++i) {
        const float x = span * ((static_cast<float>(i) + 0.5F) / kBalusters - 0.5F);
        add_lathe(mesh, paints.pale_stone, kBaluster, finer(6, detail, 5),
                  {x, kUpperFloor_m + 0.12F, 0.0F});
    }
    const float end = 0.5F * span + 0.02F;
    add_box(mesh, paints.pale_stone, {-end, kUpperFloor_m, -0.12F},
            {end, kUpperFloor_m + 0.12F, 0.12F});
    add_box(mesh, paints.pale_stone, {-end, kRail_m - 0.12F, -0.14F}, {end, kRail_m, 0.14F});
    return mesh;
}

}  // namespace foverig::builtin::atrium
