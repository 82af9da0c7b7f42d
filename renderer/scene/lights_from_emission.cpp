#include "renderer/scene/lights_from_emission.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace foverig::scene_import {
namespace {

inline constexpr std::size_t kMostLights = 8;
inline constexpr std::size_t kMostTriangles = 100'000;  ///< more than that shine in no lamp
inline constexpr float kFaintest = 0.5F;  ///< radiance; below, a glow that lights nothing
inline constexpr double kDark = 0.3;      ///< irradiance over the scene; below, lamps are for show
inline constexpr double kFlatCosine = 0.9998;  ///< 1 degree

struct Patch {
    std::uint16_t material = 0;
    dvec3 normal{0.0};   ///< sum over triangles: twice the area long, if it is flat
    double area2 = 0.0;  ///< twice the area
    std::vector<dvec3> corners;
};

float brightest(const vec3& c) {
    return std::max({c.x, c.y, c.z});
}

std::vector<std::uint32_t> shining_triangles(const Scene& scene) {
    std::vector<bool> shines(scene.materials.size());
    for (std::size_t i = 0; i < shines.size(); ++i)
        shines[i] = scene.materials[i].emission_texture < 0 &&
                    brightest(scene.materials[i].emission) >= kFaintest;
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t t = 0; t < scene.triangles.size(); ++t)
        if (shines[scene.triangle_materials[t]]) triangles.push_back(t);
    return triangles;
}

dvec3 normal_of(const Scene& scene, std::uint32_t t) {
    const uvec3& i = scene.triangles[t];
    const dvec3 a(scene.positions_m[i.x]);
    return glm::cross(dvec3(scene.positions_m[i.y]) - a, dvec3(scene.positions_m[i.z]) - a);
}

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

/// Triangles that share an edge (by position), a material and a plane belong together.
std::vector<Patch> flat_patches(const Scene& scene, const std::vector<std::uint32_t>& triangles) {
    std::vector<std::uint32_t> parent(triangles.size());
    std::iota(parent.begin(), parent.end(), 0U);
    std::map<std::array<float, 6>, std::uint32_t> first_at;
    for (std::uint32_t n = 0; n < triangles.size(); ++n) {
        const uvec3& t = scene.triangles[triangles[n]];
        for (int k = 0; k < 3; ++k) {
            const vec3* a = &scene.positions_m[t[k]];
            const vec3* b = &scene.positions_m[t[(k + 1) % 3]];
            if (std::array{b->x, b->y, b->z} < std::array{a->x, a->y, a->z}) std::swap(a, b);
            const auto [edge, fresh] =
                first_at.try_emplace({a->x, a->y, a->z, b->x, b->y, b->z}, n);
            if (fresh) continue;
            const std::uint32_t other = triangles[edge->second];
            const double cosine =
                std::abs(glm::dot(glm::normalize(normal_of(scene, other)),
                                  glm::normalize(normal_of(scene, triangles[n]))));
            if (cosine >= kFlatCosine &&
                scene.triangle_materials[other] == scene.triangle_materials[triangles[n]])
                parent[root_of(parent, n)] = root_of(parent, edge->second);
        }
    }
    std::map<std::uint32_t, Patch> patches;
    for (std::uint32_t n = 0; n < triangles.size(); ++n) {
        Patch& patch = patches[root_of(parent, n)];
        patch.material = scene.triangle_materials[triangles[n]];
        const dvec3 normal = normal_of(scene, triangles[n]);
        patch.normal += glm::dot(normal, patch.normal) < 0.0 ? -normal : normal;
        patch.area2 += glm::length(normal);
        for (int k = 0; k < 3; ++k)
            patch.corners.emplace_back(scene.positions_m[scene.triangles[triangles[n]][k]]);
    }
    std::vector<Patch> result;
    // Fine facets of a curved lamp pass the edge test one by one, but not together.
    for (auto& [_, patch] : patches)
        if (glm::length(patch.normal) > kFlatCosine * patch.area2)
            result.push_back(std::move(patch));
    return result;
}

std::vector<dvec3> distinct_corners(const Patch& patch) {
    std::vector<dvec3> distinct;
    for (const dvec3& p : patch.corners)
        if (std::find(distinct.begin(), distinct.end(), p) == distinct.end()) {
            distinct.push_back(p);
            if (distinct.size() > 4) break;
        }
    return distinct;
}

/// Corner and edges of a parallelogram with these four corners, if they are one.
bool is_parallelogram(const std::vector<dvec3>& p, AreaLight& light) {
    if (p.size() != 4) return false;
    for (std::size_t across = 1; across < 4; ++across) {
        const dvec3& b = p[across == 1 ? 2 : 1];
        const dvec3& c = p[across == 3 ? 2 : 3];
        const double off = glm::length(b + c - p[0] - p[across]);
        if (off > 1.0e-4 * glm::length(b - c)) continue;
        light.corner_m = vec3(p[0]);
        light.edge_u_m = vec3(b - p[0]);
        light.edge_v_m = vec3(c - p[0]);
        return true;
    }
    return false;
}

/// The smallest rectangle around the patch among those along its triangles' edges.
AreaLight rectangle_around(const Patch& patch) {
    const dvec3 normal = glm::normalize(patch.normal);
    AreaLight best;
    double best_area = std::numeric_limits<double>::infinity();
    const std::size_t tries = std::min<std::size_t>(patch.corners.size(), 256);
    for (std::size_t i = 0; i < tries; ++i) {
        const dvec3 edge = patch.corners[i - i % 3 + (i + 1) % 3] - patch.corners[i];
        if (!(glm::length(edge) > 0.0)) continue;
        const dvec3 u = glm::normalize(edge - normal * glm::dot(edge, normal));
        const dvec3 v = glm::cross(normal, u);
        dvec2 least(std::numeric_limits<double>::infinity());
        dvec2 most(-std::numeric_limits<double>::infinity());
        for (const dvec3& p : patch.corners) {
            const dvec3 d = p - patch.corners[0];
            const dvec2 at(glm::dot(d, u), glm::dot(d, v));
            least = glm::min(least, at);
            most = glm::max(most, at);
        }
        const dvec2 size = most - least;
        if (size.x * size.y >= best_area) continue;
        best_area = size.x * size.y;
        best.corner_m = vec3(patch.corners[0] + u * least.x + v * least.y);
        best.edge_u_m = vec3(u * size.x);
        best.edge_v_m = vec3(v * size.y);
    }
    return best;
}

AreaLight light_of(const Scene& scene, const Patch& patch) {
    AreaLight light;
    light.radiance = scene.materials[patch.material].emission;
    if (is_parallelogram(distinct_corners(patch), light)) return light;
    light = rectangle_around(patch);
    const double area_m2 = glm::length(dvec3(glm::cross(light.edge_u_m, light.edge_v_m)));
    light.radiance =
        scene.materials[patch.material].emission * static_cast<float>(0.5 * patch.area2 / area_m2);
    return light;
}

}  // namespace

std::size_t add_lights_from_emission(Scene& scene) {
    const std::vector<std::uint32_t> triangles = shining_triangles(scene);
    if (triangles.empty() || triangles.size() > kMostTriangles) return 0;
    std::vector<Patch> patches = flat_patches(scene, triangles);
    if (patches.empty()) return 0;
    const auto power = [&](const Patch& patch) {
        return patch.area2 * double{brightest(scene.materials[patch.material].emission)};
    };
    std::stable_sort(patches.begin(), patches.end(),
                     [&](const Patch& a, const Patch& b) { return power(a) > power(b); });
    double total = 0.0;
    for (const Patch& patch : patches) total += power(patch);
    const dvec3 reach_m = 0.25 * dvec3(scene.bounds.max_m - scene.bounds.min_m);
    if (0.5 * total < kDark * glm::dot(reach_m, reach_m)) {
        scene.notes.emplace_back(
            "its shining surfaces are too faint to light the scene: they are no area lights");
        return 0;
    }
    for (const Patch& patch : patches) {
        // A bulb of a thousand facets is no area light: none of them is worth sampling.
        const bool few = patches.size() <= kMostLights || power(patch) > total / 50.0;
        if (scene.area_lights.size() == kMostLights || !few ||
            power(patch) < power(patches.front()) / 1000.0)
            break;
        scene.area_lights.push_back(light_of(scene, patch));
    }
    if (scene.area_lights.size() < patches.size())
        scene.notes.push_back("of " + std::to_string(patches.size()) + " shining patches, the " +
                              std::to_string(scene.area_lights.size()) +
                              " strongest light the scene");
    return scene.area_lights.size();
}

}  // namespace foverig::scene_import
