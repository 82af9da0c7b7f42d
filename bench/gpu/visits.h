#pragma once
#include "bench/gpu/in_threads.h"
#include "bench/gpu/suites.h"
#include "renderer/trace/traverse.h"

namespace foverig::gpu {

/// What rays of a batch read, on the average.
struct Visits {
    std::uint64_t nodes = 0;
    std::uint64_t triangles = 0;

    void node() { ++nodes; }
    void triangle() { ++triangles; }
};

/// Of every n-th ray, so that about 100,000 are asked, by the kernel's own code on the host:
/// trace(ray, visits).
template <class Trace>
Json visits_of(const std::vector<Ray>& rays, std::size_t node_bytes, std::size_t hit_bytes,
               const Trace& trace) {
    const std::size_t step = std::max<std::size_t>(1, rays.size() / 100'000);
    const std::size_t asked = (rays.size() + step - 1) / step;
    if (asked == 0) return Json::object();
    std::vector<Visits> of_ray(asked);
    in_threads(asked, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) trace(rays[i * step], of_ray[i]);
    });
    Visits sum;
    for (const Visits& v : of_ray) {
        sum.nodes += v.nodes;
        sum.triangles += v.triangles;
    }
    const double nodes = static_cast<double>(sum.nodes) / static_cast<double>(asked);
    const double triangles = static_cast<double>(sum.triangles) / static_cast<double>(asked);
    const double bytes = nodes * static_cast<double>(node_bytes) +
                         triangles * static_cast<double>(sizeof(PackedTriangle)) +
                         static_cast<double>(sizeof(Ray) + hit_bytes);
    return {{"nodes", nodes}, {"triangles", triangles}, {"bytes", bytes}};
}

/// Of the wide tree.
template <bool kAny>
Json visits_of(const GpuScene& scene, const std::vector<Ray>& rays) {
    const BvhView bvh = scene.host().bvh().view();
    const SceneView& view = scene.host().view();
    return visits_of(rays, sizeof(WideNode), kAny ? sizeof(float) : sizeof(Hit),
                     [&](const Ray& ray, Visits& visits) {
                         if (scene.holes())
                             traverse<kAny, true>(bvh, view, ray, visits);
                         else
                             traverse<kAny, false>(bvh, view, ray, visits);
                     });
}

}  // namespace foverig::gpu
