// The binary BVH that foverig_gpu measures the wide one against gives the same hits, so that the
// two do the same work.
#include "bench/gpu/binary_traverse.h"

#include <gtest/gtest.h>

#include "bench/gpu/binary_bvh.h"
#include "bench/ray_kinds.h"
#include "renderer/backends/host_bvh/host_bvh_scene.h"
#include "renderer/scene/library.h"
#include "renderer/trace/build/binned_sah.h"
#include "tests/renderer/small_scenes.h"

namespace foverig {
namespace {

using bench::RayKind;
using host_bvh::HostBvhScene;

/// Bit for bit. Without holes, whose texels two compilations of one file round apart.
void expect_same_hits(const Scene& scene, std::uint32_t rays_a_kind) {
    const HostBvhScene host(scene, {});
    const BvhView wide = host.bvh().view();
    const gpu::PackedBinary packed(wide.triangles, build_binned_triangles);
    const gpu::BinaryView binary = packed.view();
    ASSERT_EQ(binary.triangles.size, wide.triangles.size);
    const bench::RayMaker make_ray(scene);
    std::size_t hits = 0;
    for (const RayKind kind : bench::kRayKinds)
        for (std::uint32_t i = 0; i < rays_a_kind; ++i) {
            Ray ray = make_ray(kind, i);
            if (i % 4 == 0) ray.t_max = 1.0F;
            const Hit a = traverse<false, false>(wide, host.view(), ray);
            const Hit b = gpu::traverse_binary<false, false>(binary, host.view(), ray);
            ASSERT_EQ(a.triangle, b.triangle) << bench::name_of(kind) << i;
            ASSERT_EQ(a.t, b.t);
            ASSERT_EQ(a.u, b.u);
            ASSERT_EQ(a.v, b.v);
            const Hit any = gpu::traverse_binary<true, false>(binary, host.view(), ray);
            ASSERT_EQ(a.missed(), any.missed());
            hits += a.missed() ? 0U : 1U;
        }
    EXPECT_GT(hits, rays_a_kind / 2);
}

TEST(BinaryTraverse, SameHitsAsTheWideTreeOnBuiltInScenes) {
    for (const BuiltinInfo& info : builtin_scenes())
        expect_same_hits(make_builtin_scene(info.name, 0.02), 5'000);
}

TEST(BinaryTraverse, AlsoFarFromTheOriginAndInOtherUnits) {
    Scene scene = make_builtin_scene("cornell", 0.1);
    expect_same_hits(bench::scaled(scene, 1.0e6F), 10'000);
    expect_same_hits(bench::scaled(scene, 1.0e-6F), 10'000);
    for (vec3& p : scene.positions_m) p += vec3(3000.0F, -2000.0F, 5000.0F);
    for (CameraKey& key : scene.camera_path) {
        key.position_m += vec3(3000.0F, -2000.0F, 5000.0F);
        key.target_m += vec3(3000.0F, -2000.0F, 5000.0F);
    }
    scene.motions.clear();
    for (Part& part : scene.parts) part.motion = kNone;
    update_bounds(scene);
    expect_same_hits(scene, 10'000);
}

TEST(BinaryTraverse, ARootThatIsALeafAndNoTriangleAtAll) {
    SmallScene s;
    s.add_quad(s.add_matte(vec3(0.5F)), {-1, -1, -2}, {2, 0, 0}, {0, 2, 0});
    expect_same_hits(*s.finish(), 100);
    const gpu::PackedBinary nothing({}, build_binned_triangles);
    EXPECT_TRUE((gpu::traverse_binary<false, false>(nothing.view(), {}, Ray{}).missed()));
}

TEST(BinaryTraverse, SeesThroughHoles) {
    const Scene scene = card_before_wall();
    const HostBvhScene host(scene, {});
    const gpu::PackedBinary packed(host.bvh().view().triangles, build_binned_triangles);
    for (int i = 0; i < 32; ++i) {
        Ray ray;
        ray.direction = {-0.97F + 0.06F * static_cast<float>(i), 0.3F, -1.0F};
        const Hit hit = gpu::traverse_binary<false, true>(packed.view(), host.view(), ray);
        EXPECT_NEAR(hit.t, ray.direction.x < 0.0F ? 2.0F : 1.0F, 1.0e-5F) << i;
    }
}

struct Visits {
    std::size_t nodes = 0;
    std::size_t triangles = 0;
    void node() { ++nodes; }
    void triangle() { ++triangles; }
};

TEST(BinaryTraverse, TheWideTreeVisitsFewerNodesForTheSameHits) {
    const Scene scene = make_builtin_scene("atrium", 0.02);
    const HostBvhScene wide(scene, {});
    const gpu::PackedBinary packed(wide.bvh().view().triangles, build_binned_triangles);
    const bench::RayMaker make_ray(scene);
    Visits of_wide;
    Visits of_binary;
    for (std::uint32_t i = 0; i < 10'000; ++i) {
        const Ray ray = make_ray(RayKind::diffuse, i);
        traverse<false, true>(wide.bvh().view(), wide.view(), ray, of_wide);
        gpu::traverse_binary<false, true>(packed.view(), wide.view(), ray, of_binary);
    }
    EXPECT_GT(of_wide.triangles, 10'000U);
    EXPECT_GT(of_binary.triangles, 10'000U);
    EXPECT_GT(of_binary.nodes, 2 * of_wide.nodes);
}

}  // namespace
}  // namespace foverig
