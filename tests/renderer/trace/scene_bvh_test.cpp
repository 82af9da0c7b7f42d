#include "renderer/trace/build/scene_bvh.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "renderer/backends/embree/split_build.h"
#include "renderer/backends/host_bvh/host_bvh_scene.h"
#include "renderer/kernels/sampling.h"
#include "renderer/scene/library.h"
#include "renderer/trace/refit.h"
#include "tests/renderer/small_scenes.h"

namespace foverig {
namespace {

using host_bvh::HostBvhScene;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

float random(std::uint32_t a, std::uint32_t b) {
    return unit_float(hash32(a, b));
}
vec3 random_point(std::uint32_t i, std::uint32_t b) {
    return {random(i, b), random(i, b + 1), random(i, b + 2)};
}

Ray ray_through(const Bounds& bounds, std::uint32_t i) {
    const vec3 size = bounds.max_m - bounds.min_m;
    Ray ray;
    ray.origin_m = bounds.min_m + size * (1.4F * random_point(i, 20) - vec3(0.2F));
    ray.direction = bounds.min_m + size * random_point(i, 30) - ray.origin_m;
    return ray;
}

HostBvhScene with_splits(const Scene& scene) {
    return HostBvhScene(scene, {true, {}, [](auto t) { return embree::build_with_splits(t, 1); }});
}

/// The box of a child as its node's bytes say, in double, where they are exact.
struct ExactBox {
    dvec3 min_m;
    dvec3 max_m;

    bool holds(const dvec3& p, double slack_m) const {
        for (int a = 0; a < 3; ++a)
            if (p[a] < min_m[a] - slack_m || p[a] > max_m[a] + slack_m) return false;
        return true;
    }
};

ExactBox box_of_child(const WideNode& node, std::uint32_t slot) {
    ExactBox box;
    for (int a = 0; a < 3; ++a) {
        const double step = node.exponent[a] == 0 ? 0.0 : std::ldexp(1.0, node.exponent[a] - 127);
        box.min_m[a] = node.origin_m[a] + step * node.bounds[a][slot];
        box.max_m[a] = node.origin_m[a] + step * node.bounds[3 + a][slot];
    }
    return box;
}

/// visit(triangle, boxes on the way to it) for each triangle of each leaf.
template <class Visit>
void walk(const BvhView& bvh, std::uint32_t at, std::vector<ExactBox>& way, const Visit& visit) {
    const WideNode& node = bvh.nodes[at];
    std::uint32_t child = node.first_child;
    for (std::uint32_t slot = 0; slot < kWidth; ++slot) {
        if (node.meta[slot] == 0) continue;
        way.push_back(box_of_child(node, slot));
        if ((node.inner >> slot & 1U) != 0U) {
            EXPECT_EQ(node.meta[slot], 32U + 24U + slot);
            walk(bvh, child++, way, visit);
        } else {
            const std::uint32_t first = node.meta[slot] & 31U;
            const auto count =
                static_cast<std::uint32_t>(std::popcount(std::uint32_t{node.meta[slot]} >> 5U));
            EXPECT_LE(first + count, 24U);
            for (std::uint32_t k = 0; k < count; ++k)
                visit(bvh.triangles[node.first_triangle + first + k], way);
        }
        way.pop_back();
    }
}

template <class Visit>
void walk(const BvhView& bvh, const Visit& visit) {
    std::vector<ExactBox> way;
    walk(bvh, 0, way, visit);
}

void expect_boxes_hold_triangles(const Scene& scene, const BvhView& bvh) {
    std::vector<int> held(scene.triangles.size());
    walk(bvh, [&](const PackedTriangle& triangle, const std::vector<ExactBox>& way) {
        ++held[number_of(triangle)];
        for (const ExactBox& box : way)
            for (int corner = 0; corner < 3; ++corner)
                ASSERT_TRUE(box.holds(
                    {triangle.row[0][corner], triangle.row[1][corner], triangle.row[2][corner]},
                    0.0));
    });
    for (const int times : held) ASSERT_EQ(times, 1);
}

TEST(SceneBvh, EachTriangleOnceAndEveryBoxAboveItHoldsIt) {
    for (const BuiltinInfo& info : builtin_scenes()) {
        const Scene scene = make_builtin_scene(info.name, 0.05);
        HostBvhScene traced(scene, {});
        expect_boxes_hold_triangles(scene, traced.bvh().view());
        traced.set_time(1.3);
        expect_boxes_hold_triangles(scene, traced.bvh().view());
    }
}

TEST(SceneBvh, SpatialSplitsLeaveNoPointOfATriangleWithoutALeaf) {
    const Scene scene = make_builtin_scene("atrium", 0.05);
    const HostBvhScene traced = with_splits(scene);
    std::vector<std::vector<ExactBox>> leaves(scene.triangles.size());
    std::size_t references = 0;
    walk(traced.bvh().view(), [&](const PackedTriangle& t, const std::vector<ExactBox>& way) {
        leaves[number_of(t)].push_back(way.back());
        ++references;
    });
    EXPECT_GT(references, scene.triangles.size() + scene.triangles.size() / 50);
    const double rounding_m = 1.0e-6 * glm::length(dvec3(scene.bounds.max_m - scene.bounds.min_m));
    for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
        const uvec3 c = scene.triangles[i];
        for (std::uint32_t k = 0; k < 20; ++k) {
            double u = random(i, k);
            double v = random(i, 100 + k);
            if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
            const dvec3 p = (1.0 - u - v) * dvec3(scene.positions_m[c.x]) +
                            u * dvec3(scene.positions_m[c.y]) + v * dvec3(scene.positions_m[c.z]);
            bool in_one = false;
            for (const ExactBox& box : leaves[i]) in_one = in_one || box.holds(p, rounding_m);
            ASSERT_TRUE(in_one) << i;
        }
    }
}

TEST(SceneBvh, RefitFindsTheHitsOfANewBuild) {
    const Scene scene = make_builtin_scene("cornell");
    ASSERT_FALSE(scene.motions.empty());
    HostBvhScene refitted(scene, {});
    for (const double time_s : {0.4, 2.0, 7.7}) {
        refitted.set_time(time_s);
        Scene posed = scene;
        const View<const vec3> p = refitted.view().positions_m;
        posed.positions_m.assign(p.begin(), p.end());
        posed.motions.clear();
        for (Part& part : posed.parts) part.motion = kNone;
        const HostBvhScene rebuilt(posed, {});
        std::size_t moved_hits = 0;
        for (std::uint32_t i = 0; i < 50'000; ++i) {
            const Ray ray = ray_through(scene.bounds, i);
            const Hit a = refitted.closest(ray);
            const Hit b = rebuilt.closest(ray);
            ASSERT_EQ(a.triangle, b.triangle) << i;
            ASSERT_EQ(a.t, b.t) << i;
            for (const Part& part : scene.parts)
                moved_hits += !a.missed() && part.motion >= 0 &&
                              a.triangle >= part.first_triangle &&
                              a.triangle < part.first_triangle + part.triangle_count;
        }
        EXPECT_GT(moved_hits, 500U);
    }
}

TEST(SceneBvh, ManyMovingPartsShareOneUpperTree) {
    SmallScene s;
    const std::uint16_t grey = s.add_matte(vec3(0.5F));
    for (int i = 0; i < 100; ++i) {
        s.add_quad(grey, {2.0F * static_cast<float>(i), 0, -5}, {1, 0, 0}, {0, 1, 0});
        s.end_part();
        s.scene().motions.push_back({{0, 0, 0}, {0, 1, 0}, 0.0F, {0, 0, 1}, 0.25F});
        s.scene().parts.back().motion = i;
    }
    const auto scene = s.finish();
    HostBvhScene traced(*scene, {});
    for (const double time_s : {0.0, 1.0, 3.0}) {
        traced.set_time(time_s);
        const double z = -5.0 + std::sin(2.0 * 3.14159265358979 * 0.25 * time_s);
        for (std::uint32_t i = 0; i < 100; ++i) {
            Ray ray;
            ray.origin_m = {2.0F * static_cast<float>(i) + 0.25F, 0.5F, 0.0F};
            const Hit hit = traced.closest(ray);
            ASSERT_EQ(hit.triangle / 2, i);
            ASSERT_NEAR(hit.t, -z, 1.0e-5);
        }
    }
}

/// Each card is twice as far away and as large as the one before: the surface area heuristic peels
/// them off one by one.
Scene rows_of_twice_larger_cards() {
    SmallScene s;
    const std::uint16_t grey = s.add_matte(vec3(0.5F));
    for (int row = 0; row < 60; ++row)
        for (int i = -26; i < 30; ++i) {
            const float size = std::exp2(static_cast<float>(i));
            s.add_quad(grey, {size, size * (1.0F + 0.01F * static_cast<float>(row)), size},
                       {0, size, 0}, {0, 0, size});
        }
    return *s.finish();
}

TEST(SceneBvh, UnluckyGeometryStaysWithinTheStack) {
    const Scene scene = rows_of_twice_larger_cards();
    for (const HostBvhScene& traced : {HostBvhScene(scene, {}), with_splits(scene)}) {
        EXPECT_LE(traced.bvh().levels(), kMostLevelsOfNodes);
        EXPECT_GE(traced.bvh().levels(), 4);
        for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
            const uvec3 c = scene.triangles[i];
            const vec3 middle =
                (scene.positions_m[c.x] + scene.positions_m[c.y] + scene.positions_m[c.z]) *
                (1.0F / 3.0F);
            Ray ray;
            ray.origin_m = middle - vec3(0.1F * middle.x, 0.0F, 0.0F);
            ray.direction = {middle.x, 0.0F, 0.0F};
            ASSERT_FALSE(traced.closest(ray).missed()) << i;
        }
    }
}

TEST(SceneBvh, AScaleThatIsAPowerOfTwoChangesNoHit) {
    const Scene scene = make_builtin_scene("atrium", 0.02);
    const HostBvhScene traced(scene, {});
    for (const int power : {-24, 30}) {
        const float factor = std::ldexp(1.0F, power);
        Scene other = scene;
        for (vec3& p : other.positions_m) p *= factor;
        const HostBvhScene of_other(other, {});
        for (std::uint32_t i = 0; i < 20'000; ++i) {
            Ray ray = ray_through(scene.bounds, i);
            const Hit hit = traced.closest(ray);
            ray.origin_m *= factor;
            ray.direction *= factor;
            const Hit of_scaled = of_other.closest(ray);
            ASSERT_EQ(hit.triangle, of_scaled.triangle) << i;
            ASSERT_NEAR(hit.t, of_scaled.t, 1.0e-6F * hit.t) << i;
        }
    }
}

/// A quad that rays from the origin along -z hit, among geometry that nothing can hit.
Scene quad_among(const std::vector<vec3>& useless) {
    SmallScene s;
    s.add_quad(s.add_matte(vec3(0.5F)), {-1, -1, -2}, {2, 0, 0}, {0, 2, 0});
    Scene scene = *s.finish();
    for (std::size_t i = 0; i + 2 < useless.size(); i += 3) {
        const auto first = static_cast<std::uint32_t>(scene.positions_m.size());
        scene.positions_m.insert(scene.positions_m.end(), useless.begin() + static_cast<int>(i),
                                 useless.begin() + static_cast<int>(i) + 3);
        scene.normals.insert(scene.normals.end(), 3, vec3(0, 0, 1));
        scene.triangles.push_back({first, first + 1, first + 2});
        scene.triangle_materials.push_back(0);
    }
    scene.parts[0].triangle_count = static_cast<std::uint32_t>(scene.triangles.size());
    scene.parts[0].vertex_count = static_cast<std::uint32_t>(scene.positions_m.size());
    return scene;
}

TEST(SceneBvh, DegenerateAndUnboundedTrianglesAreNeverHit) {
    const float inf = std::numeric_limits<float>::infinity();
    const Scene scene = quad_among({{0, 0, -1},
                                    {0, 0, -1},
                                    {0, 0, -1},  // a point
                                    {-1, 0, -1},
                                    {0, 0, -1},
                                    {1, 0, -1},  // a line
                                    {kNaN, 0, -1},
                                    {1, 0, -1},
                                    {0, 1, -1},  //
                                    {-1, -1, -1},
                                    {inf, 0, -1},
                                    {0, 1, -1},  //
                                    {-1, -1, -1},
                                    {3.0e38F, 0, -1},
                                    {0, 1, -1}});
    for (const HostBvhScene& traced : {HostBvhScene(scene, {}), with_splits(scene)}) {
        for (std::uint32_t i = 0; i < 1000; ++i) {
            Ray ray;
            ray.direction = {random(i, 0) - 0.5F, i % 4 == 0 ? 0.0F : random(i, 1) - 0.5F, -1.0F};
            const Hit hit = traced.closest(ray);
            ASSERT_LT(hit.triangle, 2U) << i;
            ASSERT_NEAR(hit.t, 2.0F, 1.0e-6F);
        }
    }
}

TEST(SceneBvh, NothingToHitIsAMiss) {
    Scene empty;
    const HostBvhScene nothing(empty, {});
    EXPECT_TRUE(nothing.closest(Ray{}).missed());
    EXPECT_FALSE(nothing.occluded(Ray{}));
    Scene all_bad = quad_among({});
    for (vec3& p : all_bad.positions_m) p.x = kNaN;
    const HostBvhScene none_held(all_bad, {});
    EXPECT_TRUE(none_held.closest(Ray{}).missed());
}

TEST(SceneBvh, RaysThatMeanNothingMiss) {
    const Scene scene = quad_among({});
    const HostBvhScene traced(scene, {});
    ASSERT_FALSE(traced.closest(Ray{}).missed());
    const float inf = std::numeric_limits<float>::infinity();
    for (const vec3 bad : {vec3(kNaN, 0, -1), vec3(0, 0, kNaN), vec3(0.0F), vec3(0, 0, -inf)}) {
        Ray ray;
        ray.direction = bad;
        EXPECT_TRUE(traced.closest(ray).missed());
        ray = {};
        ray.origin_m = {bad.x, bad.y, inf};
        EXPECT_TRUE(traced.closest(ray).missed());
    }
    for (const float bad : {kNaN, -1.0F, 1.5F}) {
        Ray ray;
        ray.t_max = bad;
        EXPECT_TRUE(traced.closest(ray).missed());
    }
}

TEST(SceneBvh, BothEndsOfTheRangeBelongToIt) {
    const Scene scene = quad_among({});
    const HostBvhScene traced(scene, {});
    Ray ray;
    ray.origin_m = {0.25F, 0.1F, 0.0F};
    ray.t_min = ray.t_max = 2.0F;
    EXPECT_FALSE(traced.closest(ray).missed());
    ray.t_min = std::nextafter(2.0F, 3.0F);
    ray.t_max = 10.0F;
    EXPECT_TRUE(traced.closest(ray).missed());
    ray.t_min = 0.0F;
    ray.t_max = std::nextafter(2.0F, 0.0F);
    EXPECT_FALSE(traced.occluded(ray));
}

TEST(SceneBvh, AHoleIsSeenThroughAndASolidTexelIsNot) {
    const Scene scene = card_before_wall();
    const HostBvhScene masked(scene, {});
    const HostBvhScene opaque(scene, {false, {}, {}});
    for (int i = 0; i < 32; ++i) {
        Ray ray;
        ray.direction = {-0.97F + 0.06F * static_cast<float>(i), 0.3F, -1.0F};
        const bool hole = ray.direction.x < 0.0F;
        EXPECT_NEAR(masked.closest(ray).t, hole ? 2.0F : 1.0F, 1.0e-5F) << i;
        EXPECT_NEAR(opaque.closest(ray).t, 1.0F, 1.0e-5F) << i;
        ray.t_max = 1.5F;
        EXPECT_EQ(masked.occluded(ray), !hole) << i;
    }
}

}  // namespace
}  // namespace foverig
