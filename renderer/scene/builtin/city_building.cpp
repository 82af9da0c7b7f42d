#include "renderer/scene/builtin/city_plan.h"
#include "renderer/scene/builtin/hash.h"
#include "renderer/scene/builtin/shapes.h"

namespace foverig::builtin::city {
namespace {

void add_water_tank(Mesh& mesh, const Paints& paints, const vec3& foot_m) {
    for (const float x : {-0.9F, 0.9F}) {
        for (const float z : {-0.9F, 0.9F}) {
            const vec3 p = foot_m + vec3{x, 0.0F, z};
            add_box(mesh, paints.metal, p - vec3{0.08F, 0.0F, 0.08F}, p + vec3{0.08F, 2.2F, 0.08F},
                    kSides);
        }
    }
    constexpr std::array<vec2, 5> kTank{vec2{0.0F, 2.2F}, vec2{1.4F, 2.2F}, vec2{1.4F, 4.6F},
                                        vec2{1.5F, 4.6F}, vec2{0.0F, 5.6F}};
    add_lathe(mesh, paints.wood, kTank, 20, foot_m);
}

/// Machines, a stair head and now and then a water tank or a mast.
void furnish_roof(Mesh& mesh, const Paints& paints, const Look& look, const vec3& roof_m,
                  vec2 size_m) {
    const float half_x = 0.5F * size_m.x - 2.6F;
    const float half_z = 0.5F * size_m.y - 2.6F;
    Dice dice(look.seed);
    constexpr unsigned kSeen = kAllFaces & ~kBottom;
    const vec3 head =
        roof_m + vec3{dice.between(-half_x, half_x), 0.0F, dice.between(-half_z, half_z)};
    add_box(mesh, look.wall, head - vec3{1.6F, 0.0F, 2.0F}, head + vec3{1.6F, 2.8F, 2.0F}, kSeen);
    add_box(mesh, paints.metal, head + vec3{-0.5F, 0.0F, 2.0F}, head + vec3{0.5F, 2.1F, 2.04F},
            kSeen);
    const int machines = 2 + dice.below(4);
    for (int i = 0; i < machines; ++i) {
        const vec3 p =
            roof_m + vec3{dice.between(-half_x, half_x), 0.0F, dice.between(-half_z, half_z)};
        const float size = dice.between(0.5F, 1.1F);
        add_box(mesh, paints.concrete, p - vec3{size, 0.0F, 0.7F * size},
                p + vec3{size, 1.3F * size, 0.7F * size}, kSeen);
        const std::array<vec2, 3> fan{vec2{0.45F * size, 1.3F * size},
                                      vec2{0.45F * size, 1.5F * size}, vec2{0.0F, 1.45F * size}};
        add_lathe(mesh, paints.metal, fan, 12, p);
    }
    if (dice.chance(0.35F))
        add_water_tank(mesh, paints, roof_m + vec3{0.4F * half_x, 0.0F, -0.5F * half_z});
    if (dice.chance(0.3F)) {
        const vec3 p = roof_m + vec3{-0.6F * half_x, 0.0F, 0.5F * half_z};
        add_box(mesh, paints.metal, p - vec3{0.05F, 0.0F, 0.05F},
                p + vec3{0.05F, dice.between(4.0F, 8.0F), 0.05F}, kSides | kTop);
    }
}

}  // namespace

void add_building(Mesh& mesh, const Paints& paints, const Look& look, const vec3& centre_m,
                  vec2 size_m, unsigned street_sides) {
    const float top_m = look.height_m();
    for (unsigned k = 0; k < 4; ++k) {
        const float width_m = k % 2 == 0 ? size_m.x : size_m.y;
        const float out_m = 0.5F * (k % 2 == 0 ? size_m.y : size_m.x);
        const float turns = 0.25F * static_cast<float>(k);
        const Placement placement{centre_m + rotate_y({0.0F, 0.0F, out_m}, turns), turns};
        if ((street_sides >> k & 1U) != 0U) {
            mesh.append(make_facade(paints, look, width_m), placement);
            continue;
        }
        Mesh blank;
        const Surface wall = look.windows == Windows::tall ? paints.walls[0] : paints.concrete;
        add_quad(blank, wall, {-0.5F * width_m, 0.0F, 0.0F}, {width_m, 0.0F, 0.0F},
                 {0.0F, top_m, 0.0F});
        add_box(blank, wall, {-0.5F * width_m, top_m, -0.3F}, {0.5F * width_m, top_m + 0.7F, 0.0F},
                kAllFaces & ~kBottom);
        mesh.append(blank, placement);
    }
    const vec3 roof_m = centre_m + vec3{0.0F, top_m, 0.0F};
    add_quad(mesh, paints.roof, roof_m + vec3{-0.5F * size_m.x, 0.0F, 0.5F * size_m.y},
             {size_m.x, 0.0F, 0.0F}, {0.0F, 0.0F, -size_m.y});
    furnish_roof(mesh, paints, look, roof_m, size_m);
}

}  // namespace foverig::builtin::city
