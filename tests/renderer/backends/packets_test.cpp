#include "renderer/backends/embree/packets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "renderer/backends/cpu/cpu_backend.h"
#include "renderer/kernels/sampling.h"
#include "renderer/scene/library.h"
#include "tests/renderer/small_scenes.h"

namespace foverig::embree {
namespace {

float random(std::uint32_t a, std::uint32_t b) {
    return unit_float(hash32(a, b));
}
vec3 random_point(std::uint32_t i, std::uint32_t b) {
    return {random(i, b), random(i, b + 1), random(i, b + 2)};
}

Scene triangle_soup() {
    SmallScene s;
    const std::uint16_t grey = s.add_matte(vec3(0.5F));
    for (std::uint32_t i = 0; i < 400; ++i) {
        s.add_quad(grey, 4.0F * random_point(i, 0) - vec3(2.0F), random_point(i, 3) - vec3(0.5F),
                   random_point(i, 6) - vec3(0.5F));
        if (i % 100 == 99) s.end_part();  // several geometries: triangle numbers must run on
    }
    return *s.finish();
}

std::vector<Ray> random_rays(const Bounds& bounds, int n) {
    std::vector<Ray> rays;
    const vec3 size = bounds.max_m - bounds.min_m;
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(n); ++i) {
        Ray r;
        r.origin_m = bounds.min_m + size * (1.4F * random_point(i, 20) - vec3(0.2F));
        r.direction = (bounds.min_m + size * random_point(i, 30)) - r.origin_m;
        r.t_max = i % 3 == 0 ? 0.7F : 1.0e30F;
        r.t_min = i % 5 == 0 ? 0.1F : 0.0F;
        rays.push_back(r);
    }
    return rays;
}

RTCRay single(const Ray& r) {
    RTCRay s{};
    s.org_x = r.origin_m.x;
    s.org_y = r.origin_m.y;
    s.org_z = r.origin_m.z;
    s.dir_x = r.direction.x;
    s.dir_y = r.direction.y;
    s.dir_z = r.direction.z;
    s.tnear = r.t_min;
    s.tfar = r.t_max;
    s.mask = ~0U;
    return s;
}

RTCRayHit closest_alone(const EmbreeScene& scene, const Ray& ray) {
    RTCRayHit s{};
    s.ray = single(ray);
    s.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    s.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(scene.handle(), &s, nullptr);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene.handle(), &context, &s);
#endif
    return s;
}

bool occluded_alone(const EmbreeScene& scene, const Ray& ray) {
    RTCRay s = single(ray);
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded1(scene.handle(), &s, nullptr);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene.handle(), &context, &s);
#endif
    return s.tfar < 0.0F;
}

/// Packets of n rays, answers by lane; room past the end as the contract asks.
std::vector<Hit> closest_in_packets(const EmbreeScene& scene, const std::vector<Ray>& rays, int n,
                                    std::vector<int>* reports = nullptr) {
    std::vector<Ray> padded = rays;
    padded.resize(rays.size() + kPacket);
    std::vector<Hit> hits(rays.size());
    closest(
        scene.handle(), scene.first_triangles(), n,
        [&](int i) { return padded[static_cast<std::size_t>(i)]; },
        [&](int i, const Hit& hit) {
            hits.at(static_cast<std::size_t>(i)) = hit;
            if (reports != nullptr) ++reports->at(static_cast<std::size_t>(i));
        });
    return hits;
}

void expect_closest_agrees(const Scene& scene) {
    const EmbreeScene embree(scene, {});
    const std::vector<Ray> rays = random_rays(scene.bounds, 5000);
    const std::vector<Hit> hits = closest_in_packets(embree, rays, static_cast<int>(rays.size()));
    int hit_count = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const RTCRayHit alone = closest_alone(embree, rays[i]);
        const bool missed = alone.hit.geomID == RTC_INVALID_GEOMETRY_ID;
        ASSERT_EQ(hits[i].missed(), missed) << i;
        if (missed) continue;
        ++hit_count;
        ASSERT_NEAR(hits[i].t, alone.ray.tfar, 1.0e-5F * alone.ray.tfar + 1.0e-6F) << i;
        if (hits[i].triangle != embree.first_triangles()[alone.hit.geomID] + alone.hit.primID)
            continue;  // two at one distance
        ASSERT_NEAR(hits[i].u, alone.hit.u, 2.0e-3F) << i;
        ASSERT_NEAR(hits[i].v, alone.hit.v, 2.0e-3F) << i;
        // The point by the barycentrics lies on the ray.
        const uvec3 corner = scene.triangles[hits[i].triangle];
        const vec3 p = (1.0F - hits[i].u - hits[i].v) * scene.positions_m[corner.x] +
                       hits[i].u * scene.positions_m[corner.y] +
                       hits[i].v * scene.positions_m[corner.z];
        ASSERT_LT(glm::length(p - (rays[i].origin_m + hits[i].t * rays[i].direction)), 1.0e-3F)
            << i;
    }
    EXPECT_GT(hit_count, 1000);
}

TEST(Packets, ClosestHitsAreThoseOfSingleRaysInASoup) {
    expect_closest_agrees(triangle_soup());
}
TEST(Packets, ClosestHitsAreThoseOfSingleRaysInTheCornellBox) {
    expect_closest_agrees(make_builtin_scene("cornell"));
}

TEST(Packets, VisibilityIsThatOfSingleRays) {
    for (const Scene& scene : {triangle_soup(), make_builtin_scene("cornell")}) {
        const EmbreeScene embree(scene, {});
        constexpr int kSamples = 4;
        const std::vector<Ray> rays = random_rays(scene.bounds, 1000 * kSamples + 64);
        const auto ray_of = [&](int slot, int sample) {
            return rays[static_cast<std::size_t>(slot * kSamples + sample) % rays.size()];
        };
        const auto weight_of = [](int slot, int sample) {
            return (slot + sample) % 7 == 0 ? 0.0F : static_cast<float>(1 << sample);
        };
        std::vector<float> expected(1000, 0.0F);
        std::uint64_t expected_traced = 0;
        int open = 0;
        for (int slot = 0; slot < 1000; ++slot) {
            float& sum = expected[static_cast<std::size_t>(slot)];
            for (int sample = 0; sample < kSamples; ++sample) {
                if (weight_of(slot, sample) <= 0.0F) continue;
                ++expected_traced;
                if (!occluded_alone(embree, ray_of(slot, sample))) sum += weight_of(slot, sample);
            }
            open += sum > 0.0F ? 1 : 0;
        }
        EXPECT_TRUE(open > 100 && open < 1000) << open;
        for (const int per_packet : {1, 2, 4}) {
            std::vector<float> sums(1000, -1.0F);
            const std::uint64_t traced = visible(
                embree.handle(), 1000, kSamples, per_packet,
                [&](int slot, int sample) {
                    return WeightedRay{ray_of(slot, sample), weight_of(slot, sample)};
                },
                [&](int slot, float sum) { sums.at(static_cast<std::size_t>(slot)) = sum; });
            EXPECT_EQ(sums, expected) << per_packet;
            EXPECT_EQ(traced, expected_traced) << per_packet;
        }
    }
}

TEST(Packets, ATailReportsItsOwnLanesOnceAndNoOther) {
    const Scene scene = triangle_soup();
    const EmbreeScene embree(scene, {});
    const std::vector<Ray> rays = random_rays(scene.bounds, 100);
    for (const int n : {0, 1, 15, 16, 17, 31, 33}) {
        std::vector<int> reports(rays.size());
        closest_in_packets(embree, rays, n, &reports);
        for (std::size_t i = 0; i < rays.size(); ++i)
            ASSERT_EQ(reports[i], static_cast<int>(i) < n ? 1 : 0) << n;
        int sums = 0;
        const std::uint64_t traced = visible(
            embree.handle(), n, 2, 2,
            [&](int slot, int) {
                return WeightedRay{rays[static_cast<std::size_t>(slot)], 1.0F};
            },
            [&](int, float) { ++sums; });
        EXPECT_EQ(sums, n);
        EXPECT_EQ(traced, 2U * static_cast<std::uint64_t>(n));
    }
}

TEST(AlphaFilter, AHoleIsSeenThroughAndASolidTexelIsNot) {
    const Scene scene = card_before_wall();
    std::vector<Ray> rays(32);
    for (std::size_t i = 0; i < rays.size(); ++i)
        rays[i].direction = {-0.97F + 0.06F * static_cast<float>(i), 0.3F, -1.0F};
    const EmbreeScene masked(scene, {});
    const EmbreeScene opaque(scene, {false});
    const std::vector<Hit> through = closest_in_packets(masked, rays, 32);
    const std::vector<Hit> card = closest_in_packets(opaque, rays, 32);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const bool hole = rays[i].direction.x < 0.0F;
        EXPECT_NEAR(through[i].t, hole ? 2.0F : 1.0F, 1.0e-5F) << i;
        EXPECT_EQ(through[i].triangle >= 2, hole) << i;
        EXPECT_NEAR(card[i].t, 1.0F, 1.0e-5F) << i;
        rays[i].t_max = 1.5F;
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
        float open = 0.0F;
        visible(
            masked.handle(), 1, 1, 1,
            [&](int, int) {
                return WeightedRay{rays[i], 1.0F};
            },
            [&](int, float sum) { open = sum; });
        EXPECT_EQ(open, rays[i].direction.x < 0.0F ? 1.0F : 0.0F) << i;
    }
}

TEST(EmbreeScene, MovesItsPartsToTheirPlaceInTime) {
    SmallScene s;
    s.add_quad(s.add_matte(vec3(0.5F)), {-1, -1, -2}, {2, 0, 0}, {0, 2, 0});
    s.scene().motions.push_back({{0, 0, -2}, {0, 1, 0}, 0.0F, {0, 0, 1}, 0.25F});
    s.end_part();
    s.scene().parts[0].motion = 0;
    const auto scene = s.finish();
    EmbreeScene embree(*scene, {});
    const std::vector<Ray> rays(16);
    for (const double time : {0.0, 1.0, 3.0, 0.5}) {
        embree.set_time(time);
        EXPECT_NEAR(closest_in_packets(embree, rays, 16)[7].t,
                    2.0 - std::sin(2.0 * 3.14159265358979 * 0.25 * time), 1.0e-5)
            << time;
    }
}

TEST(CpuBackend, RunsEveryTileOnceAndAddsItsPassesUp) {
    const Scene scene = triangle_soup();
    for (const int threads : {1, 3}) {
        CpuBackend backend(scene, {true, true, threads});
        std::vector<int> runs(200);
        backend.for_tiles(200, [&](Lane& lane, int thread, int tile) {
            ASSERT_LT(thread, threads);
            lane.launch("count", 1, [&](int) { ++runs[static_cast<std::size_t>(tile)]; });
        });
        EXPECT_EQ(std::count(runs.begin(), runs.end(), 1), 200);
        const PassTable passes = backend.take_passes();
        ASSERT_EQ(passes.entries().size(), 1U);
        EXPECT_EQ(passes.entries()[0].name, "count");
        EXPECT_EQ(passes.entries()[0].launches, 200U);
        EXPECT_TRUE(backend.take_passes().entries().empty());
    }
}

}  // namespace
}  // namespace foverig::embree
