// The device's refit, on the host: other arrays, filled by what an upload carries, and kernels run
// in another order, end with the bytes of SceneBvh::refit.
#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <limits>

#include "renderer/backends/host_bvh/host_bvh_scene.h"
#include "renderer/kernels/sampling.h"
#include "renderer/scene/library.h"
#include "renderer/trace/build/binned_sah.h"
#include "renderer/trace/build/moved_parts.h"
#include "renderer/trace/traverse.h"
#include "tests/renderer/small_scenes.h"

namespace foverig {
namespace {

using host_bvh::HostBvhScene;

/// What a device holds of a scene, and what of it moves.
class Elsewhere {
  public:
    explicit Elsewhere(const HostBvhScene& scene)
        : plan_(scene.bvh().plan()),
          corners_(scene.view().triangles),
          positions_m_(scene.view().positions_m.begin(), scene.view().positions_m.end()),
          normals_(scene.view().normals.begin(), scene.view().normals.end()),
          nodes_(scene.bvh().view().nodes.begin(), scene.bvh().view().nodes.end()),
          triangles_(scene.bvh().view().triangles.begin(), scene.bvh().view().triangles.end()),
          staged_positions_m_(moving_vertices(plan_)),
          staged_normals_(moving_vertices(plan_)),
          upper_(plan_.upper.capacity()),
          roots_(plan_.upper.capacity()) {}

    void move(const SceneView& posed) {
        pack_moved(plan_, posed,
                   {view_of(staged_positions_m_), view_of(staged_normals_), view_of(upper_),
                    view_of(roots_)});
        for_each_run(plan_, [&](const VertexRun& run, std::size_t at) {
            std::copy_n(staged_positions_m_.data() + at, run.count,
                        positions_m_.data() + run.first);
            std::copy_n(staged_normals_.data() + at, run.count, normals_.data() + run.first);
        });
        const float poison = std::numeric_limits<float>::quiet_NaN();
        std::vector<Box> boxes(plan_.node_count(), Box{vec3(poison), vec3(poison)});
        refit_passes(
            plan_,
            {view_of(std::as_const(positions_m_)), corners_, view_of(nodes_), view_of(triangles_),
             view_of(boxes), view_of(std::as_const(upper_)), view_of(std::as_const(roots_))},
            [](const char*, int n, const auto& kernel) {
                for (int i = n; i-- > 0;) kernel(i);
            });
    }

    void expect_same_bytes(const HostBvhScene& scene) const {
        const BvhView bvh = scene.bvh().view();
        ASSERT_EQ(nodes_.size(), bvh.nodes.size);
        EXPECT_EQ(std::memcmp(nodes_.data(), bvh.nodes.data, nodes_.size() * sizeof(WideNode)), 0);
        EXPECT_EQ(std::memcmp(triangles_.data(), bvh.triangles.data,
                              triangles_.size() * sizeof(PackedTriangle)),
                  0);
        const SceneView& s = scene.view();
        for (std::size_t i = 0; i < positions_m_.size(); ++i) {
            ASSERT_EQ(positions_m_[i], s.positions_m[i]);
            ASSERT_EQ(normals_[i], s.normals[i]);
        }
    }

  private:
    RefitPlan plan_;
    View<const uvec3> corners_;
    std::vector<vec3> positions_m_;
    std::vector<vec3> normals_;
    std::vector<WideNode> nodes_;
    std::vector<PackedTriangle> triangles_;
    std::vector<vec3> staged_positions_m_;
    std::vector<vec3> staged_normals_;
    std::vector<WideNode> upper_;
    std::vector<std::uint32_t> roots_;
};

/// A ball of so many triangles that turns and swings, beside the last one.
void add_ball(SmallScene& s, std::uint16_t material, int rings) {
    Scene& scene = s.scene();
    const int at = static_cast<int>(scene.motions.size());
    const vec3 middle_m(3.0F * static_cast<float>(at), 0.0F, -5.0F);
    const auto on_ball = [&](int ring, int step) {
        const float turn = 6.2831853F * static_cast<float>(step) / static_cast<float>(2 * rings);
        const float tilt = 3.1415927F * static_cast<float>(ring) / static_cast<float>(rings);
        return middle_m + vec3(std::sin(tilt) * std::cos(turn), std::cos(tilt),
                               std::sin(tilt) * std::sin(turn));
    };
    for (int ring = 1; ring < rings; ++ring)
        for (int step = 0; step < 2 * rings; ++step) {
            const vec3 corner_m = on_ball(ring, step);
            s.add_quad(material, corner_m, on_ball(ring, step + 1) - corner_m,
                       on_ball(ring + 1, step) - corner_m + vec3(1.0e-3F));
        }
    s.end_part();
    scene.motions.push_back({middle_m, {0.6F, 0, 0.8F}, 1.5F, {0, 1, 0}, 0.5F});
    scene.parts.back().motion = at;
}

/// Balls whose trees have one, three and more levels, and floors between them that stand still.
Scene balls_and_floors() {
    SmallScene s;
    const std::uint16_t grey = s.add_matte(vec3(0.5F));
    for (const int rings : {2, 24, 4, 9}) {
        add_ball(s, grey, rings);
        if (rings == 4) continue;  // its neighbour's vertices follow at once
        s.add_quad(grey, {-9, -3.0F - static_cast<float>(rings), -9}, {40, 0, 0}, {0, 0, 20});
        s.end_part();
    }
    return *s.finish();
}

TEST(Refit, OtherArraysAndAnotherOrderGiveTheSameBytes) {
    for (const Scene& scene : {balls_and_floors(), make_builtin_scene("cornell")}) {
        HostBvhScene host(scene, {});
        ASSERT_TRUE(host.bvh().plan().moves());
        Elsewhere elsewhere(host);
        elsewhere.expect_same_bytes(host);
        for (const double time_s : {0.3, 4.0, 0.0}) {
            host.set_time(time_s);
            elsewhere.move(host.view());
            elsewhere.expect_same_bytes(host);
        }
    }
}

TEST(Refit, WithoutTheMoveTheBytesAreOthers) {
    const Scene scene = balls_and_floors();
    HostBvhScene host(scene, {});
    const std::vector<WideNode> before(host.bvh().view().nodes.begin(),
                                       host.bvh().view().nodes.end());
    host.set_time(0.3);
    const View<const WideNode> after = host.bvh().view().nodes;
    std::size_t moved = 0;
    for (std::size_t i = 0; i < after.size; ++i)
        moved += std::memcmp(&before[i], &after[i], sizeof(WideNode)) != 0 ? 1U : 0U;
    EXPECT_GE(moved, host.bvh().plan().node_count());
}

TEST(RefitPlan, EachInnerChildIsOnTheNextLevel) {
    const Scene scene = balls_and_floors();
    const HostBvhScene host(scene, {});
    const RefitPlan& plan = host.bvh().plan();
    ASSERT_GE(plan.level_ends.size(), 3U);
    EXPECT_EQ(plan.level_ends.front() - plan.first_node, 4U);  // the roots
    EXPECT_EQ(plan.level_ends.back(), host.bvh().view().nodes.size);
    std::vector<int> parents(host.bvh().view().nodes.size);
    std::uint32_t first = plan.first_node;
    for (std::size_t level = 0; level < plan.level_ends.size(); ++level) {
        const std::uint32_t end = plan.level_ends[level];
        ASSERT_LT(first, end);
        for (std::uint32_t at = first; at < end; ++at) {
            const WideNode& node = host.bvh().view().nodes[at];
            const int inner = std::popcount(std::uint32_t{node.inner});
            for (int k = 0; k < inner; ++k) {
                const std::uint32_t child = node.first_child + static_cast<std::uint32_t>(k);
                ASSERT_GE(child, end);
                ASSERT_LT(child, plan.level_ends[level + 1]);
                ++parents[child];
            }
        }
        first = end;
    }
    for (std::uint32_t at = plan.level_ends[0]; at < plan.level_ends.back(); ++at)
        ASSERT_EQ(parents[at], 1) << at;
}

TEST(RefitPlan, ItsVerticesAreThoseOfMovingPartsAndNeighboursAreOneRun) {
    const Scene scene = balls_and_floors();
    const HostBvhScene host(scene, {});
    std::vector<int> carried(scene.positions_m.size());
    for (const VertexRun& run : host.bvh().plan().vertices)
        for (std::uint32_t v = run.first; v < run.first + run.count; ++v) ++carried[v];
    for (const Part& part : scene.parts)
        for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v)
            ASSERT_EQ(carried[v], part.motion >= 0 ? 1 : 0);
    EXPECT_EQ(host.bvh().plan().vertices.size(), 3U);  // of four parts
    EXPECT_FALSE(HostBvhScene(scene, {true, {true, false}, {}}).bvh().plan().moves());
}

TEST(Refit, ATriangleThatLeavesTheRangeIsNotHitUntilItComesBack) {
    SmallScene s;
    s.add_quad(s.add_matte(vec3(0.5F)), {-1, -1, -2}, {2, 0, 0}, {0, 2, 0});
    s.end_part();
    s.scene().motions.push_back({});
    s.scene().parts.back().motion = 0;
    const auto scene = s.finish();
    std::vector<vec3> at_m = scene->positions_m;
    const std::size_t moving_parts[] = {0};
    SceneBvh bvh(*scene, view_of(at_m), moving_parts, true, build_binned_triangles);
    const auto hit = [&] { return traverse<false, false>(bvh.view(), {}, Ray{}); };
    EXPECT_NEAR(hit().t, 2.0F, 1.0e-6F);
    for (const float away : {1.9e18F, std::numeric_limits<float>::quiet_NaN()}) {
        for (vec3& p : at_m) p.z = away;
        bvh.refit(view_of(std::as_const(at_m)));
        EXPECT_TRUE(hit().missed());
        for (vec3& p : at_m) p.z = -3.0F;
        bvh.refit(view_of(std::as_const(at_m)));
        EXPECT_NEAR(hit().t, 3.0F, 1.0e-6F);
    }
}

TEST(BvhView, TheRootsGridHoldsTheScene) {
    for (const Scene& scene : {balls_and_floors(), make_builtin_scene("cornell")}) {
        HostBvhScene host(scene, {});
        for (const double time_s : {0.0, 1.3}) {
            host.set_time(time_s);
            const Box grid = grid_box(host.bvh().view().nodes[0]);
            for (const uvec3& c : scene.triangles)
                for (const std::uint32_t v : {c.x, c.y, c.z})
                    for (int a = 0; a < 3; ++a) {
                        ASSERT_GE(host.view().positions_m[v][a], grid.min_m[a]);
                        ASSERT_LE(host.view().positions_m[v][a], grid.max_m[a]);
                    }
        }
    }
}

}  // namespace
}  // namespace foverig
