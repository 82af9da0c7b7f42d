#include <cmath>

#include "bench/gpu/binary_bvh.h"
#include "bench/gpu/device_binary.h"
#include "bench/gpu/visits.h"
#include "bench/statistics.h"
#include "renderer/backends/cuda/cuda_tracer.h"
#include "renderer/kernels/camera_rays.h"
#include "renderer/kernels/frame_queue.h"
#include "renderer/kernels/light_rays.h"
#include "renderer/kernels/shade_surface.h"
#include "renderer/trace/build/binned_sah.h"

namespace foverig::gpu {
namespace {

constexpr float kShortReachShare = 0.05F;  ///< of the scene's diagonal, as bench/cases.cpp
constexpr float kUnbounded_m = 1.0e30F;

/// Where a primary ray met the scene: what secondary rays start from.
struct Spot {
    vec3 origin_m;
    vec3 normal;  ///< unit, geometric, on the viewer's side
};

std::vector<Ray> primary_rays(const EyeView& view) {
    const int n = view.width_px * view.height_px;
    std::vector<PackedPixel> pixels(static_cast<std::size_t>(n));
    std::vector<Ray> rays(pixels.size());
    const QueuePixels queue{view.width_px, view.height_px, view_of(pixels), 0U};
    const CameraRays make_ray{EyeRays(view), view_of(std::as_const(pixels)), {}};
    in_threads(pixels.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            queue(static_cast<int>(i));
            rays[i] = make_ray(static_cast<int>(i));
        }
    });
    return rays;
}

std::vector<Spot> spots_of(const SceneView& scene, const std::vector<Ray>& rays,
                           const std::vector<Hit>& hits) {
    std::vector<Spot> spots;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (hits[i].missed()) continue;
        const uvec3 c = scene.triangles[hits[i].triangle];
        const vec3 a = scene.positions_m[c.x];
        const vec3 u = scene.positions_m[c.y] - a;
        const vec3 v = scene.positions_m[c.z] - a;
        vec3 normal = glm::cross(u, v);
        const float length = glm::length(normal);
        if (!(length > 0.0F)) continue;
        normal *= (glm::dot(normal, rays[i].direction) > 0.0F ? -1.0F : 1.0F) / length;
        const float offset_m = origin_offset_m(a, a + u, a + v);
        spots.push_back({a + hits[i].u * u + hits[i].v * v + offset_m * normal, normal});
    }
    return spots;
}

vec3 light_position_m(const Scene& scene) {
    if (!scene.point_lights.empty()) return scene.point_lights[0].position_m;
    if (scene.area_lights.empty()) return 0.5F * (scene.bounds.min_m + scene.bounds.max_m);
    const AreaLight& lamp = scene.area_lights[0];
    return lamp.corner_m + 0.5F * (lamp.edge_u_m + lamp.edge_v_m);
}

/// make(spot, number) over as many rays as the batch has; sample-major, as trace_visible takes
/// them.
template <class Make>
std::vector<Ray> rays_from(const std::vector<Spot>& spots, std::uint32_t count, const Make& make) {
    std::vector<Ray> rays(spots.empty() ? 0 : count);
    in_threads(rays.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            rays[i] = make(spots[i % spots.size()], static_cast<std::uint32_t>(i));
    });
    return rays;
}

Ray scattered(const Spot& spot, std::uint32_t number, float reach_m) {
    const vec2 point = scrambled_point(number, hash32(number / 16U));
    return {spot.origin_m, frame_about(spot.normal).world(cosine_direction(point)), 0.0F, reach_m};
}

/// `visits`: nodes, triangles and bytes that a ray reads.
Json row_of(std::size_t rays, const std::vector<double>& ms, double hit_share, const Json& visits) {
    const double median_ms = bench::median(ms);
    const double mrays_s = median_ms > 0.0 ? static_cast<double>(rays) / median_ms * 1e-3 : 0.0;
    Json row = {{"rays", rays},           {"ms", ms},
                {"median_ms", median_ms}, {"mrays_s", mrays_s},
                {"hit_share", hit_share}, {"a_ray_reads", visits}};
    if (visits.contains("bytes"))
        row["read_gbytes_s"] = visits["bytes"].get<double>() * mrays_s * 1e-3;
    return row;
}

Json closest_row(const cuda::TracedHits& traced, const Json& visits) {
    std::size_t hits = 0;
    for (const Hit& hit : traced.hits) hits += hit.missed() ? 0U : 1U;
    return row_of(traced.hits.size(), traced.ms,
                  static_cast<double>(hits) / static_cast<double>(traced.hits.size()), visits);
}

Json visible_row(const cuda::TracedShadows& traced, const Json& visits) {
    std::size_t hits = 0;
    for (const float visible : traced.visible) hits += visible > 0.0F ? 0U : 1U;
    return row_of(traced.visible.size(), traced.ms,
                  static_cast<double>(hits) / static_cast<double>(traced.visible.size()), visits);
}

/// The same rays by a plain binary BVH over the same triangles. `hits_apart`: rays that it answers
/// otherwise than the wide one did.
Json binary_row(const GpuScene& scene, const std::vector<Ray>& rays, const cuda::TracedHits& wide,
                int repetitions) {
    const SceneView& view = scene.host().view();
    const PackedBinary packed(scene.host().bvh().view().triangles, build_binned_triangles);
    const BinaryView bvh = packed.view();
    const Json visits =
        visits_of(rays, sizeof(PairNode), sizeof(Hit), [&](const Ray& ray, Visits& v) {
            if (scene.holes())
                traverse_binary<false, true>(bvh, view, ray, v);
            else
                traverse_binary<false, false>(bvh, view, ray, v);
        });
    const cuda::TracedHits traced =
        closest_by_binary(view, bvh, scene.holes(), view_of(rays), repetitions);
    std::size_t apart = 0;
    for (std::size_t i = 0; i < rays.size(); ++i)
        apart += traced.hits[i].triangle == wide.hits[i].triangle ? 0U : 1U;
    Json row = closest_row(traced, visits);
    row["hits_apart"] = apart;
    row["nodes"] = bvh.nodes.size;
    row["wide_over_binary"] = bench::median(traced.ms) / bench::median(wide.ms);
    return row;
}

}  // namespace

Json ray_rates(const GpuScene& scene, const GpuSettings& settings) {
    cuda::CudaTracer tracer(scene.host().view(), scene.host().bvh().view(), scene.holes());
    const int side = static_cast<int>(std::sqrt(static_cast<double>(settings.rays)));
    const std::vector<Ray> primary = primary_rays(scene.view(side, side));
    const cuda::TracedHits seen = tracer.closest(view_of(primary), settings.repetitions);
    Json rows = {{"scene_bytes", tracer.scene_bytes()},
                 {"primary", closest_row(seen, visits_of<false>(scene, primary))}};
    const std::vector<Spot> spots = spots_of(scene.host().view(), primary, seen.hits);
    if (spots.empty()) return rows;  // the camera sees nothing to send rays from
    const Scene& s = scene.scene();
    const auto time_visible = [&](const std::vector<Spot>& from, const auto& make) {
        const std::vector<Ray> rays = rays_from(from, settings.rays, make);
        return visible_row(tracer.visible(view_of(rays), settings.repetitions),
                           visits_of<true>(scene, rays));
    };
    const vec3 light_m = light_position_m(s);
    rows["shadow"] = time_visible(spots, [&](const Spot& spot, std::uint32_t) {
        return Ray{spot.origin_m, light_m - spot.origin_m, 0.0F, kShadowReach};
    });
    // Sixteen rays a surface, so surfaces of a sixteenth of the pixels: every fourth each way.
    const int few = side / 4;
    const std::vector<Ray> coarse = primary_rays(scene.view(few, few));
    const std::vector<Spot> occluded =
        spots_of(scene.host().view(), coarse, tracer.closest(view_of(coarse)).hits);
    const float reach_m = kShortReachShare * glm::length(s.bounds.max_m - s.bounds.min_m);
    const auto occlusion = [&](float bound_m) {
        return time_visible(
            occluded.empty() ? spots : occluded,
            [=](const Spot& spot, std::uint32_t i) { return scattered(spot, i, bound_m); });
    };
    rows["ao16"] = occlusion(reach_m);
    rows["ao16_unbounded"] = occlusion(kUnbounded_m);
    const std::vector<Ray> diffuse = rays_from(
        spots, settings.rays,
        [](const Spot& spot, std::uint32_t i) { return scattered(spot, i, kUnbounded_m); });
    const cuda::TracedHits wide = tracer.closest(view_of(diffuse), settings.repetitions);
    rows["diffuse"] = closest_row(wide, visits_of<false>(scene, diffuse));
    rows["diffuse_by_binary"] = binary_row(scene, diffuse, wide, settings.repetitions);
    return rows;
}

}  // namespace foverig::gpu
