#include "renderer/scene/default_lights.h"

#include <algorithm>
#include <numbers>

namespace foverig::scene_import {
namespace {

/// Radiance that surfaces of the scene's average colour shall have at the light's typical distance.
inline constexpr float kRadiance = 0.45F;

/// What a material reflects on average: its colour times the coarsest texel.
float albedo_of(const Scene& scene, const Material& material) {
    const float factor = luminance(material.diffuse);
    if (material.diffuse_texture < 0) return factor;
    const Texture& texture = scene.textures[static_cast<std::size_t>(material.diffuse_texture)];
    std::size_t last = texture.first_texel;
    for (std::uint32_t level = 0; level + 1 < texture.level_count; ++level)
        last += std::size_t{std::max(1U, texture.width >> level)} *
                std::max(1U, texture.height >> level);
    const std::uint32_t texel = scene.texels[last];
    const vec3 srgb(static_cast<float>(texel & 255U), static_cast<float>((texel >> 8U) & 255U),
                    static_cast<float>((texel >> 16U) & 255U));
    const float value = luminance(srgb) / 255.0F;
    return factor * value * value;
}

/// Weighted by area.
float average_albedo(const Scene& scene) {
    std::vector<double> area_m2(scene.materials.size(), 0.0);
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
        const uvec3& i = scene.triangles[t];
        const vec3& a = scene.positions_m[i.x];
        area_m2[scene.triangle_materials[t]] +=
            double{glm::length(glm::cross(scene.positions_m[i.y] - a, scene.positions_m[i.z] - a))};
    }
    double sum = 0.0;
    double total = 0.0;
    for (std::size_t m = 0; m < area_m2.size(); ++m) {
        sum += area_m2[m] * double{albedo_of(scene, scene.materials[m])};
        total += area_m2[m];
    }
    return total > 0.0 ? static_cast<float>(sum / total) : 0.5F;
}

vec3 intensity_for(const Scene& scene, float distance2_m2) {
    return vec3(kRadiance * std::numbers::pi_v<float> / std::max(average_albedo(scene), 0.05F) *
                distance2_m2);
}

/// Distances to what a lamp in this cell would light.
struct Reach {
    float mean_m = 0.0F;
    float mean_square_m2 = 0.0F;
};

Reach reach_of(const Occupancy& grid, const ivec3& lamp) {
    Reach reach;
    for (int i = 0; i < 27; ++i) {
        const ivec3 direction(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if (direction == ivec3(0)) continue;
        const float distance_m = static_cast<float>(grid.look(lamp, direction).cells + 1) *
                                 grid.cell_m() * glm::length(vec3(direction));
        reach.mean_m += distance_m / 26.0F;
        reach.mean_square_m2 += distance_m * distance_m / 26.0F;
    }
    return reach;
}

}  // namespace

PointLight light_over_flight(const Scene& scene, const Occupancy& grid,
                             const std::vector<CameraKey>& keys) {
    PointLight light{keys.front().position_m, vec3(0.0F)};
    float best = 0.0F;
    float distance2_m2 = 1.0F;
    for (const CameraKey& key : keys) {
        const ivec3 eye = grid.cell_at(key.position_m);
        if (!grid.inside(eye)) continue;
        const ivec3 lamp = eye + ivec3(0, grid.look(eye, ivec3(0, 1, 0)).cells / 3, 0);
        const Reach reach = reach_of(grid, lamp);
        // In the open rather than at the end of a long view.
        const float score = reach.mean_m * static_cast<float>(std::min(grid.clearance(lamp), 8));
        if (score <= best) continue;
        best = score;
        distance2_m2 = reach.mean_square_m2;
        light.position_m = vec3(key.position_m.x, grid.centre_m(lamp).y, key.position_m.z);
    }
    light.intensity = intensity_for(scene, distance2_m2);
    return light;
}

PointLight light_beside_object(const Scene& scene) {
    const vec3 extent_m = scene.bounds.max_m - scene.bounds.min_m;
    const vec3 off_m = glm::length(extent_m) * vec3(0.6F, 1.0F, 0.8F);
    return {scene.bounds.min_m + 0.5F * extent_m + off_m,
            intensity_for(scene, glm::dot(off_m, off_m))};
}

}  // namespace foverig::scene_import
