#pragma once
#include <cmath>

#include "renderer/scene/scene.h"

namespace foverig::gpu {

/// A wavy ring of 262,144 triangles that turns and swings, and nothing else.
inline Scene moving_mesh() {
    constexpr std::uint32_t kAround = 512;
    constexpr std::uint32_t kThrough = 256;
    constexpr double kTurn_rad = 6.283185307179586;
    Scene scene;
    scene.name = "moving-mesh";
    scene.materials = {Material{}};
    for (std::uint32_t i = 0; i < kAround; ++i)
        for (std::uint32_t k = 0; k < kThrough; ++k) {
            const double a = kTurn_rad * i / kAround;
            const double b = kTurn_rad * k / kThrough;
            const double thick_m = 0.4 + 0.05 * std::sin(9.0 * a + 4.0 * b);
            const dvec3 outward(std::cos(a) * std::cos(b), std::sin(b), std::sin(a) * std::cos(b));
            scene.positions_m.push_back(
                vec3(dvec3(std::cos(a), 0.0, std::sin(a)) + thick_m * outward));
            scene.normals.push_back(vec3(outward));
            const auto at = [&](std::uint32_t di, std::uint32_t dk) {
                return (i + di) % kAround * kThrough + (k + dk) % kThrough;
            };
            scene.triangles.push_back({at(0, 0), at(0, 1), at(1, 1)});
            scene.triangles.push_back({at(0, 0), at(1, 1), at(1, 0)});
        }
    scene.triangle_materials.assign(scene.triangles.size(), 0);
    Part part;
    part.triangle_count = static_cast<std::uint32_t>(scene.triangles.size());
    part.vertex_count = static_cast<std::uint32_t>(scene.positions_m.size());
    part.motion = 0;
    scene.parts = {part};
    scene.motions = {Motion{{0.1F, 0, 0}, {0.6F, 0, 0.8F}, 0.7F, {0, 0.5F, 0}, 0.3F}};
    scene.camera_path = {CameraKey{}};
    update_bounds(scene);
    check_scene(scene);
    return scene;
}

}  // namespace foverig::gpu
