#pragma once
// Passes over queues of rays, one ray at a time, with the contract of embree/packets.h.
#include "renderer/backends/host_bvh/host_bvh_scene.h"

namespace foverig::host_bvh {

/// make_ray(i) -> Ray for i in [0, n); on_hit(i, Hit).
template <class MakeRay, class OnHit>
void closest(const HostBvhScene& scene, int n, const MakeRay& make_ray, const OnHit& on_hit) {
    for (int i = 0; i < n; ++i) {
        Hit hit = scene.closest(make_ray(i));
        if (hit.missed()) hit = {};
        on_hit(i, hit);
    }
}

/// make_ray(slot, sample) -> WeightedRay; on_sum(slot, sum of the weights of unoccluded samples).
/// Returns the number of rays traced.
template <class MakeRay, class OnSum>
std::uint64_t visible(const HostBvhScene& scene, int n, int samples, const MakeRay& make_ray,
                      const OnSum& on_sum) {
    std::uint64_t traced = 0;
    for (int slot = 0; slot < n; ++slot) {
        float sum = 0.0F;
        for (int sample = 0; sample < samples; ++sample) {
            const WeightedRay r = make_ray(slot, sample);
            if (!(r.weight > 0.0F)) continue;
            ++traced;
            if (!scene.occluded(r.ray)) sum += r.weight;
        }
        on_sum(slot, sum);
    }
    return traced;
}

}  // namespace foverig::host_bvh
