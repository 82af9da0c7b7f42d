#include "renderer/scene/builtin/grid.h"
#include "renderer/scene/builtin/scene_builder.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

namespace foverig::builtin {
namespace {

// A room of 5.5 m, ten times the box of Cornell's measurements, so that a head has space in it.
constexpr float kSide_m = 5.5F;
constexpr float kHalf_m = 0.5F * kSide_m;

struct Paints {
    std::uint16_t white, red, green, blue, lamp, metal;
};

Paints add_paints(SceneBuilder& builder) {
    Paints paints{};
    // Close to the paints of the box at Cornell.
    paints.white = builder.add_matte({0.73F, 0.73F, 0.71F});
    paints.red = builder.add_matte({0.61F, 0.06F, 0.05F});
    paints.green = builder.add_matte({0.12F, 0.45F, 0.10F});
    paints.blue = builder.add_matte({0.20F, 0.32F, 0.62F});
    paints.lamp = builder.add_glowing({7.0F, 6.2F, 4.8F});
    Material metal;
    metal.diffuse = {0.72F, 0.43F, 0.12F};
    metal.specular = vec3{0.22F, 0.18F, 0.12F};
    metal.shininess = 40.0F;
    metal.reflectance = 0.25F;
    paints.metal = builder.add_material(metal);
    return paints;
}

Mesh make_room(const Paints& paints) {
    Mesh mesh;
    const vec3 x{kSide_m, 0.0F, 0.0F};
    const vec3 y{0.0F, kSide_m, 0.0F};
    const vec3 z{0.0F, 0.0F, kSide_m};
    const vec3 low{-kHalf_m, 0.0F, -kHalf_m};
    add_quad(mesh, {paints.white}, low + z, x, -z);
    add_quad(mesh, {paints.white}, low + y, x, z);
    add_quad(mesh, {paints.white}, low, x, y);
    add_quad(mesh, {paints.red}, low + z, -z, y);
    add_quad(mesh, {paints.green}, low + x, z, y);
    return mesh;
}

Mesh make_block(std::uint16_t material, const vec3& size_m) {
    Mesh mesh;
    const vec3 half{0.5F * size_m.x, 0.0F, 0.5F * size_m.z};
    add_box(mesh, {material}, -half, half + vec3{0.0F, size_m.y, 0.0F}, kAllFaces & ~kBottom);
    return mesh;
}

/// (2, 3) torus knot about the y axis through the origin, swept with a round section.
Mesh make_knot(std::uint16_t material, int rings, int sides) {
    const auto centre = [](float u) {
        const float radius = 0.46F + 0.2F * cosine(3.0F * u);
        return vec3{radius * cosine(2.0F * u), 0.22F * sine(3.0F * u), -radius * sine(2.0F * u)};
    };
    const auto point = [&](float u, float v) {
        const vec3 along = normalize(centre(u + 0.001F) - centre(u - 0.001F));
        const vec3 side = normalize(cross(along, {0.0F, 1.0F, 0.0F}));
        const vec3 up = cross(side, along);
        return centre(u) + 0.11F * (side * cosine(v) + up * sine(v));
    };
    Mesh mesh;
    // v wraps by point(); grid seams in v are smoothed because the section closes on itself.
    add_grid(mesh, material, rings, sides, true, point, [](float u, float v) {
        return vec2{u, v};
    });
    for (std::size_t i = 0; i <= static_cast<std::size_t>(rings); ++i) {
        const std::size_t last =
            i + static_cast<std::size_t>(rings + 1) * static_cast<std::size_t>(sides);
        const vec3 both = normalize(mesh.normals[i] + mesh.normals[last]);
        mesh.normals[i] = both;
        mesh.normals[last] = both;
    }
    return mesh;
}

}  // namespace

Scene make_cornell(double detail) {
    SceneBuilder builder("cornell");
    const Paints paints = add_paints(builder);
    Mesh still = make_room(paints);
    still.append(make_block(paints.white, {1.65F, 1.65F, 1.65F}), {{0.92F, 0.0F, 0.85F}, 0.045F});
    still.append(make_block(paints.white, {1.65F, 3.3F, 1.65F}), {{-0.95F, 0.0F, -0.85F}, -0.047F});
    add_blob(still, {paints.blue}, {-1.55F, 0.45F, 1.45F}, vec3{0.45F}, finer(64, detail, 8));

    constexpr float kLampHalf_m = 0.65F;
    constexpr float kLampHeight_m = kSide_m - 0.02F;
    // The lamp's face lies above the light's plane, so that it does not hide the light.
    add_quad(still, {paints.lamp}, {-kLampHalf_m, kSide_m - 0.01F, -kLampHalf_m},
             {2.0F * kLampHalf_m, 0.0F, 0.0F}, {0.0F, 0.0F, 2.0F * kLampHalf_m});
    builder.add_part(std::move(still));

    Mesh knot;
    const vec3 hover_m{0.92F, 2.35F, 0.85F};
    knot.append(make_knot(paints.metal, finer(288, detail, 24), finer(16, detail, 6)), {hover_m});
    Motion motion;
    motion.pivot_m = hover_m;
    motion.axis = normalize({0.25F, 1.0F, 0.1F});
    motion.rate_rad_s = 1.2F;
    motion.swing_m = {0.0F, 0.15F, 0.0F};
    motion.swing_hz = 0.4F;
    builder.add_moving_part(std::move(knot), motion);

    Scene& scene = builder.scene();
    scene.point_lights.push_back({{0.0F, kSide_m - 1.2F, 0.3F}, vec3{11.0F, 10.2F, 9.0F}});
    scene.area_lights.push_back({{-kLampHalf_m, kLampHeight_m, -kLampHalf_m},
                                 {2.0F * kLampHalf_m, 0.0F, 0.0F},
                                 {0.0F, 0.0F, 2.0F * kLampHalf_m},
                                 {7.0F, 6.2F, 4.8F}});
    scene.ambient = vec3{0.2F, 0.19F, 0.18F};
    scene.background = vec3{0.01F, 0.01F, 0.012F};
    const vec3 middle{0.1F, 1.9F, -0.2F};
    scene.camera_path = {{{0.0F, 2.6F, 5.6F}, {0.0F, 2.3F, 0.0F}},
                         {{-1.9F, 3.2F, 4.0F}, middle},
                         {{0.2F, 2.4F, 2.9F}, middle + vec3{0.5F, 0.3F, 0.0F}},
                         {{2.0F, 3.6F, 3.2F}, middle},
                         {{0.6F, 2.6F, 5.2F}, {0.0F, 2.4F, 0.0F}}};
    return builder.finish();
}

}  // namespace foverig::builtin
