#include "renderer/scene/builtin/atrium_plan.h"
#include "renderer/scene/builtin/grid.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

namespace foverig::builtin::atrium {
namespace {

constexpr float kVaultSpring_m = kSpring_m;
constexpr float kVaultRise_m = 1.25F;
constexpr float kCeiling_m = kEaves_m - 0.5F;

struct Rect {
    float x0, x1, z0, z1;
    vec3 at(float x, float y, float z) const { return {mix(x0, x1, x), y, mix(z0, z1, z)}; }
};

/// Groin vault: two crossing half-elliptic barrels; each of its four cells is smooth, the groins
/// between them are sharp.
void add_vault(Mesh& mesh, Surface surface, const Rect& rect, int cells) {
    const vec3 middle = rect.at(0.5F, kVaultSpring_m, 0.5F);
    const float half_x = 0.5F * (rect.x1 - rect.x0);
    const float half_z = 0.5F * (rect.z1 - rect.z0);
    for (int quarter = 0; quarter < 4; ++quarter) {
        // The cell reaches from the crown (v = 0) to one side (v = 1); u runs across it.
        const auto point = [&](float u, float v) {
            const float across = (2.0F * u - 1.0F) * v;
            const float rise = std::sqrt(clamp(1.0F - across * across, 0.0F, 1.0F));
            vec2 p{across, v};
            if (quarter == 1) p = {v, -across};
            if (quarter == 2) p = {-across, -v};
            if (quarter == 3) p = {-v, across};
            return middle + vec3{p.x * half_x, kVaultRise_m * rise, p.y * half_z};
        };
        // Half circles are vertical where they spring; equal angles divide them evenly.
        const auto eased = [&](float u, float v) {
            return point(0.5F - 0.5F * cosine(0.5F * u), v);
        };
        add_grid(mesh, surface.material, 2 * cells, cells, false, eased, [&](float u, float v) {
            const vec3 p = eased(u, v);
            return vec2{p.x, p.z} / surface.period_m;
        });
    }
}

/// Flat ceiling of beams and panels.
void add_coffers(Mesh& mesh, const Paints& paints, const Rect& rect, int nx, int nz) {
    add_quad(mesh, paints.wood, rect.at(0.0F, kCeiling_m, 0.0F), {rect.x1 - rect.x0, 0.0F, 0.0F},
             {0.0F, 0.0F, rect.z1 - rect.z0});
    constexpr unsigned kSeen = kSides | kBottom;
    const float low = kCeiling_m - 0.16F;
    for (int i = 0; i <= nx; ++i) {
        const float x = mix(rect.x0, rect.x1, static_cast<float>(i) / static_cast<float>(nx));
        add_box(mesh, paints.wood, {x - 0.06F, low, rect.z0}, {x + 0.06F, kCeiling_m, rect.z1},
                kSeen);
    }
    for (int i = 0; i <= nz; ++i) {
        const float z = mix(rect.z0, rect.z1, static_cast<float>(i) / static_cast<float>(nz));
        add_box(mesh, paints.wood, {rect.x0, low + 0.03F, z - 0.05F},
                {rect.x1, kCeiling_m, z + 0.05F}, kSeen);
    }
    for (int i = 0; i < nx; ++i) {
        for (int j = 0; j < nz; ++j) {
            const vec3 p =
                rect.at((static_cast<float>(i) + 0.5F) / static_cast<float>(nx), kCeiling_m,
                        (static_cast<float>(j) + 0.5F) / static_cast<float>(nz));
            add_box(mesh, paints.pale_stone, p - vec3{0.11F, 0.05F, 0.11F},
                    p + vec3{0.11F, 0.0F, 0.11F}, kSeen);
        }
    }
}

/// Outer wall of both storeys at z = -kGallery_m, from x0 to x1, with skirting and a string course.
void add_outer_wall(Mesh& mesh, const Paints& paints, float x0, float x1) {
    const float z = -kGallery_m;
    const vec3 along{x1 - x0, 0.0F, 0.0F};
    add_quad(mesh, paints.brick, {x0, 0.0F, z}, along, {0.0F, kUpperFloor_m, 0.0F});
    add_quad(mesh, paints.plaster, {x0, kUpperFloor_m, z}, along,
             {0.0F, kCeiling_m - kUpperFloor_m, 0.0F});
    constexpr unsigned kSeen = kTop | kFront | kBottom;
    add_box(mesh, paints.stone, {x0, 0.0F, z}, {x1, 0.35F, z + 0.05F}, kSeen);
    add_box(mesh, paints.pale_stone, {x0, kSpring_m - 0.16F, z}, {x1, kSpring_m, z + 0.07F}, kSeen);
    add_box(mesh, paints.stone, {x0, kUpperFloor_m, z}, {x1, kUpperFloor_m + 0.9F, z + 0.04F},
            kSeen);
    add_box(mesh, paints.wood, {x0, kUpperFloor_m + 0.9F, z},
            {x1, kUpperFloor_m + 0.98F, z + 0.07F}, kSeen);
}

void add_floors(Mesh& mesh, const Paints& paints, const Rect& rect) {
    const vec3 x{rect.x1 - rect.x0, 0.0F, 0.0F};
    const vec3 z{0.0F, 0.0F, rect.z1 - rect.z0};
    add_quad(mesh, paints.floor, rect.at(0.0F, 0.0F, 1.0F), x, -z);
    add_quad(mesh, paints.floor, rect.at(0.0F, kUpperFloor_m, 1.0F), x, -z);
}

void add_pilaster(Mesh& mesh, const Paints& paints, float x, float low_m, float high_m) {
    const float z = -kGallery_m;
    constexpr unsigned kSeen = kAllFaces & ~kBack;
    add_box(mesh, paints.pale_stone, {x - 0.24F, low_m, z}, {x + 0.24F, low_m + 0.3F, z + 0.2F},
            kSeen);
    add_box(mesh, paints.stone, {x - 0.19F, low_m + 0.3F, z}, {x + 0.19F, high_m - 0.2F, z + 0.14F},
            kSeen);
    add_box(mesh, paints.pale_stone, {x - 0.24F, high_m - 0.2F, z}, {x + 0.24F, high_m, z + 0.2F},
            kSeen);
}

}  // namespace

Mesh make_gallery_bay(const Paints& paints, double detail) {
    Mesh mesh;
    const float half = 0.5F * kBay_m;
    const Rect rect{-half, half, -kGallery_m, -kWallHalf_m};
    add_floors(mesh, paints, {-half, half, -kGallery_m, kWallHalf_m});
    add_vault(mesh, paints.vault, rect, finer(4, detail, 3));
    add_coffers(mesh, paints, rect, 4, 5);
    add_outer_wall(mesh, paints, -half, half);
    add_pilaster(mesh, paints, -half, 0.0F, kSpring_m);
    add_pilaster(mesh, paints, -half, kUpperFloor_m, kCeiling_m);
    const vec3 slope{0.0F, 1.5F, -(kGallery_m + 0.85F)};
    add_quad(mesh, paints.roof, {-half, kEaves_m + 0.02F, kWallHalf_m + 0.3F}, {kBay_m, 0.0F, 0.0F},
             slope);
    add_box(mesh, paints.terracotta, {-half, kEaves_m - 0.06F, kWallHalf_m + 0.24F},
            {half, kEaves_m + 0.06F, kWallHalf_m + 0.36F}, kTop | kBottom | kFront);
    return mesh;
}

Mesh make_gallery_corner(const Paints& paints, double detail) {
    // Local origin on the court's corner; the corner square lies towards -x and -z.
    Mesh mesh;
    const Rect rect{-kGallery_m, -kWallHalf_m, -kGallery_m, -kWallHalf_m};
    add_floors(mesh, paints, {-kGallery_m, kWallHalf_m, -kGallery_m, kWallHalf_m});
    add_vault(mesh, paints.vault, rect, finer(4, detail, 3));
    add_coffers(mesh, paints, rect, 5, 5);
    add_outer_wall(mesh, paints, -kGallery_m, 0.0F);
    Mesh other;
    add_outer_wall(other, paints, 0.0F, kGallery_m);
    mesh.append(other, {vec3{0.0F}, 0.25F});
    // The neighbours' roofs meet over the corner; from there the valley rises to the ridge.
    const float out = kGallery_m + 0.3F;
    const float ridge_m = kEaves_m + 1.52F;
    const vec3 valley{0.0F, kEaves_m + 0.02F + 1.5F * (kWallHalf_m + 0.3F) / (kGallery_m + 0.85F),
                      0.0F};
    const auto facet = [&](const vec3& along, const vec3& a, const vec3& b) {
        const vec3 normal = normalize(cross(a - valley, b - valley));
        const auto vertex = [&](const vec3& p) {
            return mesh.add_vertex(p, normal,
                                   vec2{dot(p, along), -3.0F * p.y} / paints.roof.period_m);
        };
        const std::uint32_t first = vertex(valley);
        const std::uint32_t second = vertex(a);
        mesh.add_triangle(first, second, vertex(b), paints.roof.material);
    };
    const vec3 ridge{-out, ridge_m, -out};
    facet({1.0F, 0.0F, 0.0F}, {0.0F, ridge_m, -out}, ridge);
    facet({0.0F, 0.0F, 1.0F}, ridge, {-out, ridge_m, 0.0F});
    return mesh;
}

Mesh make_door(const Paints& paints) {
    Mesh mesh;
    const float z = -kGallery_m;
    constexpr unsigned kSeen = kAllFaces & ~kBack;
    add_box(mesh, paints.pale_stone, {-0.85F, 0.0F, z}, {-0.62F, 2.5F, z + 0.16F}, kSeen);
    add_box(mesh, paints.pale_stone, {0.62F, 0.0F, z}, {0.85F, 2.5F, z + 0.16F}, kSeen);
    add_box(mesh, paints.pale_stone, {-0.95F, 2.5F, z}, {0.95F, 2.8F, z + 0.2F}, kSeen);
    add_box(mesh, paints.wood, {-0.62F, 0.02F, z}, {0.62F, 2.5F, z + 0.07F}, kSeen);
    for (const float y : {0.35F, 1.2F, 2.1F}) {
        add_box(mesh, paints.iron, {-0.6F, y, z + 0.07F}, {0.6F, y + 0.07F, z + 0.09F}, kSeen);
    }
    add_blob(mesh, paints.iron, {0.42F, 1.1F, z + 0.12F}, vec3{0.05F}, 10);
    return mesh;
}

Mesh make_window(const Paints& paints) {
    Mesh mesh;
    const float z = -kGallery_m;
    const float low = kUpperFloor_m + 1.15F;
    const float high = low + 1.5F;
    constexpr unsigned kSeen = kAllFaces & ~kBack;
    add_box(mesh, paints.iron, {-0.5F, low, z}, {0.5F, high, z + 0.03F}, kSeen);
    for (const float x : {-0.62F, 0.5F}) {
        add_box(mesh, paints.pale_stone, {x, low, z}, {x + 0.12F, high, z + 0.1F}, kSeen);
    }
    add_box(mesh, paints.pale_stone, {-0.7F, high, z}, {0.7F, high + 0.18F, z + 0.14F}, kSeen);
    add_box(mesh, paints.pale_stone, {-0.7F, low - 0.12F, z}, {0.7F, low, z + 0.18F}, kSeen);
    for (const float x : {-0.28F, -0.02F, 0.24F}) {
        add_box(mesh, paints.wood, {x, low, z + 0.03F}, {x + 0.04F, high, z + 0.06F}, kSeen);
    }
    for (const float y : {0.48F, 0.98F}) {
        add_box(mesh, paints.wood, {-0.5F, low + y, z + 0.03F}, {0.5F, low + y + 0.04F, z + 0.055F},
                kSeen);
    }
    return mesh;
}

}  // namespace foverig::builtin::atrium
