#include "renderer/scene/builtin/city_plan.h"
#include "renderer/scene/builtin/shapes.h"

namespace foverig::builtin::city {
namespace {

constexpr float kPaint_m = 0.008F;  // paint lies this high over the asphalt

void add_mark(Mesh& mesh, const Paints& paints, float x, float z, float size_x, float size_z) {
    add_quad(mesh, paints.paint_white, {x - 0.5F * size_x, kPaint_m, z + 0.5F * size_z},
             {size_x, 0.0F, 0.0F}, {0.0F, 0.0F, -size_z});
}

/// Dashed middle line and zebra crossings of the stretch between two crossings, along z.
void mark_stretch(Mesh& mesh, const Paints& paints, float length_m) {
    const float clear_m = length_m - 9.0F;
    for (float z = -0.5F * clear_m; z < 0.5F * clear_m - 2.0F; z += 5.0F)
        add_mark(mesh, paints, 0.0F, z + 1.0F, 0.14F, 2.0F);
    for (const float side : {-1.0F, 1.0F}) {
        const float z = side * (0.5F * length_m - 2.2F);
        for (int i = 0; i < 11; ++i)
            add_mark(mesh, paints, static_cast<float>(i) - 5.0F, z, 0.5F, 2.6F);
        add_mark(mesh, paints, side * -2.9F, z - side * 2.2F, 5.2F, 0.3F);
    }
    for (const float x : {-3.7F, 3.7F}) {
        for (float z = -0.5F * clear_m + 2.0F; z < 0.5F * clear_m - 2.0F; z += 6.0F) {
            add_mark(mesh, paints, x + (x < 0.0F ? -1.1F : 1.1F), z, 2.2F, 0.1F);
        }
    }
}

}  // namespace

void lay_streets(Mesh& mesh, const Paints& paints, int blocks_x, int blocks_z) {
    const float half_x = 0.5F * kPitchX_m * static_cast<float>(blocks_x) + kStreet_m;
    const float half_z = 0.5F * kPitchZ_m * static_cast<float>(blocks_z) + kStreet_m;
    add_quad(mesh, paints.asphalt, {-half_x, 0.0F, half_z}, {2.0F * half_x, 0.0F, 0.0F},
             {0.0F, 0.0F, -2.0F * half_z});
    const float meadow_m = 700.0F;
    add_quad(mesh, paints.grass, {-half_x - meadow_m, -0.05F, half_z + meadow_m},
             {2.0F * (half_x + meadow_m), 0.0F, 0.0F}, {0.0F, 0.0F, -2.0F * (half_z + meadow_m)});
    Mesh along_z;
    mark_stretch(along_z, paints, kPitchZ_m - kStreet_m);
    Mesh along_x;
    mark_stretch(along_x, paints, kPitchX_m - kStreet_m);
    for (int i = 0; i <= blocks_x; ++i) {
        for (int j = 0; j <= blocks_z; ++j) {
            const float x =
                kPitchX_m * (static_cast<float>(i) - 0.5F * static_cast<float>(blocks_x));
            const float z =
                kPitchZ_m * (static_cast<float>(j) - 0.5F * static_cast<float>(blocks_z));
            if (j < blocks_z) mesh.append(along_z, {{x, 0.0F, z + 0.5F * kPitchZ_m}});
            if (i < blocks_x) mesh.append(along_x, {{x + 0.5F * kPitchX_m, 0.0F, z}, 0.25F});
        }
    }
}

Mesh make_street_lamp(const Paints& paints) {
    Mesh mesh;
    constexpr std::array<vec2, 6> kPole{vec2{0.16F, 0.0F}, vec2{0.16F, 0.3F}, vec2{0.09F, 0.6F},
                                        vec2{0.06F, 3.0F}, vec2{0.05F, 6.4F}, vec2{0.0F, 6.45F}};
    add_lathe(mesh, paints.metal, kPole, 10);
    add_box(mesh, paints.metal, {-0.04F, 6.3F, 0.0F}, {0.04F, 6.38F, 1.9F});
    add_box(mesh, paints.metal, {-0.16F, 6.26F, 1.2F}, {0.16F, 6.42F, 2.1F});
    add_quad(mesh, {paints.lamp, 1.0F}, {-0.13F, 6.255F, 1.25F}, {0.26F, 0.0F, 0.0F},
             {0.0F, 0.0F, 0.8F});
    return mesh;
}

Mesh make_bench(const Paints& paints) {
    Mesh mesh;
    for (int i = 0; i < 4; ++i) {
        const float z = 0.13F * static_cast<float>(i);
        add_box(mesh, paints.wood, {-0.9F, 0.42F, z}, {0.9F, 0.46F, z + 0.1F});
    }
    for (int i = 0; i < 3; ++i) {
        const float y = 0.56F + 0.15F * static_cast<float>(i);
        add_box(mesh, paints.wood, {-0.9F, y, -0.06F}, {0.9F, y + 0.1F, -0.02F});
    }
    for (const float x : {-0.75F, 0.7F}) {
        add_box(mesh, paints.metal, {x, 0.0F, 0.0F}, {x + 0.05F, 0.42F, 0.48F});
        add_box(mesh, paints.metal, {x, 0.42F, -0.1F}, {x + 0.05F, 0.95F, -0.06F});
    }
    return mesh;
}

}  // namespace foverig::builtin::city
