// No ray leaves a closed mesh from inside, wherever between its triangles it is aimed.
#include <gtest/gtest.h>

#include <map>

#include "renderer/backends/embree/split_build.h"
#include "renderer/backends/host_bvh/host_bvh_scene.h"
#include "renderer/kernels/sampling.h"
#include "tests/renderer/small_scenes.h"

namespace foverig {
namespace {

float random(std::uint32_t a, std::uint32_t b) {
    return unit_float(hash32(a, b));
}

Scene scene_of(std::vector<vec3> positions_m, std::vector<uvec3> triangles) {
    Scene scene;
    scene.name = "closed";
    scene.materials = {Material{}};
    scene.normals.assign(positions_m.size(), vec3(0.0F, 1.0F, 0.0F));
    scene.triangle_materials.assign(triangles.size(), 0);
    Part part;
    part.triangle_count = static_cast<std::uint32_t>(triangles.size());
    part.vertex_count = static_cast<std::uint32_t>(positions_m.size());
    scene.parts = {part};
    scene.positions_m = std::move(positions_m);
    scene.triangles = std::move(triangles);
    scene.camera_path = {CameraKey{}};
    update_bounds(scene);
    return scene;
}

/// An octahedron whose triangles were cut in four `cuts` times, on a sphere.
Scene sphere(int cuts, float radius_m, const vec3& middle_m) {
    std::vector<vec3> p{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<uvec3> t{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                         {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int cut = 0; cut < cuts; ++cut) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [it, fresh] = middles.try_emplace(std::minmax(a, b), p.size());
            if (fresh) p.push_back(glm::normalize(p[a] + p[b]));
            return it->second;
        };
        std::vector<uvec3> finer;
        for (const uvec3& c : t) {
            const uvec3 m{middle(c.x, c.y), middle(c.y, c.z), middle(c.z, c.x)};
            finer.insert(finer.end(), {{c.x, m.x, m.z}, {m.x, c.y, m.y}, {m.z, m.y, c.z}, m});
        }
        t = finer;
    }
    for (vec3& at : p) at = middle_m + radius_m * at;
    return scene_of(p, t);
}

/// A unit cube's surface, n x n quads a side.
Scene cube(std::uint32_t n) {
    std::vector<vec3> p;
    std::vector<uvec3> t;
    for (int side = 0; side < 6; ++side) {
        const int axis = side / 2;
        const auto first = static_cast<std::uint32_t>(p.size());
        for (std::uint32_t i = 0; i <= n; ++i) {
            for (std::uint32_t j = 0; j <= n; ++j) {
                vec3 at(static_cast<float>(side % 2));
                at[(axis + 1) % 3] = static_cast<float>(i) / static_cast<float>(n);
                at[(axis + 2) % 3] = static_cast<float>(j) / static_cast<float>(n);
                p.push_back(at);
                if (i == n || j == n) continue;
                const std::uint32_t c = first + i * (n + 1) + j;
                t.push_back({c, c + n + 1, c + n + 2});
                t.push_back({c, c + n + 2, c + 1});
            }
        }
    }
    return scene_of(p, t);
}

/// Ray i at a corner, at the middle of an edge, or at a random point of an edge.
Ray at_an_edge(const Scene& scene, const vec3& origin_m, std::uint32_t i) {
    const uvec3 c = scene.triangles[hash32(i, 1) % scene.triangles.size()];
    const vec3 a = scene.positions_m[c.x];
    const vec3 b = scene.positions_m[c.y];
    const float share = i % 3 == 0 ? 0.0F : i % 3 == 1 ? 0.5F : random(i, 2);
    Ray ray;
    ray.origin_m = origin_m;
    ray.direction = a + share * (b - a) - origin_m;
    return ray;
}

void expect_no_leak(const Scene& scene, float inner_radius_m, std::uint32_t rays) {
    const vec3 middle_m = 0.5F * (scene.bounds.min_m + scene.bounds.max_m);
    const host_bvh::HostBvhScene plain(scene, {});
    const host_bvh::HostBvhScene split(
        scene, {true, {}, [](auto t) { return embree::build_with_splits(t, 1); }});
    for (const host_bvh::HostBvhScene* traced : {&plain, &split}) {
        std::uint32_t missed = 0;
        for (std::uint32_t i = 0; i < rays; ++i) {
            const vec3 away(random(i, 3) - 0.5F, random(i, 4) - 0.5F, random(i, 5) - 0.5F);
            const vec3 origin_m = i % 5 == 0 ? middle_m : middle_m + inner_radius_m * away;
            const Ray ray = at_an_edge(scene, origin_m, i);
            missed += traced->closest(ray).missed() || !traced->occluded(ray) ? 1U : 0U;
        }
        EXPECT_EQ(missed, 0U);
    }
}

TEST(Watertight, NoRayAtAnEdgeLeavesASphere) {
    expect_no_leak(sphere(4, 1.0F, vec3(0.0F)), 1.0F, 100'000);
}
TEST(Watertight, NorOneFarFromTheSceneOrigin) {
    expect_no_leak(sphere(4, 1.0F, {1000.0F, -2000.0F, 500.0F}), 1.0F, 100'000);
}
TEST(Watertight, NorATinyOrAHugeOne) {
    expect_no_leak(sphere(3, 1.0e-6F, vec3(0.0F)), 1.0e-6F, 50'000);
    expect_no_leak(sphere(3, 1.0e-15F, vec3(0.0F)), 1.0e-15F, 50'000);
    expect_no_leak(sphere(3, 1.0e15F, vec3(0.0F)), 1.0e15F, 50'000);
}

TEST(Watertight, NoRayAlongAnAxisLeavesACubeThroughItsGrid) {
    const Scene scene = cube(16);
    expect_no_leak(scene, 0.9F, 50'000);
    const host_bvh::HostBvhScene traced(scene, {});
    for (std::uint32_t i = 0; i < 50'000; ++i) {
        Ray ray;
        const int axis = static_cast<int>(i % 3);
        for (int a = 0; a < 3; ++a)
            ray.origin_m[a] =
                static_cast<float>(1 + hash32(i, 6 + static_cast<unsigned>(a)) % 15) / 16.0F;
        ray.direction = vec3(0.0F);
        ray.direction[axis] = i % 2 == 0 ? 1.0F : -1.0F;
        const Hit hit = traced.closest(ray);
        const float expected = i % 2 == 0 ? 1.0F - ray.origin_m[axis] : ray.origin_m[axis];
        ASSERT_FALSE(hit.missed()) << i;
        ASSERT_NEAR(hit.t, expected, 1.0e-6F) << i;
    }
}

}  // namespace
}  // namespace foverig
