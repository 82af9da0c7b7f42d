#pragma once
// Passes over queues of rays, sixteen at a time: rays are made in registers and L1 by the pass's
// own functor, traced, and handed to its sink, so that a queue's rays never travel through memory.
#include <bit>
#include <cstdint>
#include <limits>

#include "renderer/backends/embree/embree_api.h"
#include "renderer/trace/ray.h"
#include "renderer/view.h"

namespace foverig::embree {

template <class Rays>
inline void set_lane(Rays& rays, int lane, const Ray& ray) {
    rays.org_x[lane] = ray.origin_m.x;
    rays.org_y[lane] = ray.origin_m.y;
    rays.org_z[lane] = ray.origin_m.z;
    rays.dir_x[lane] = ray.direction.x;
    rays.dir_y[lane] = ray.direction.y;
    rays.dir_z[lane] = ray.direction.z;
    rays.tnear[lane] = ray.t_min;
    rays.tfar[lane] = ray.t_max;
    rays.time[lane] = 0.0F;
    rays.mask[lane] = ~0U;
    rays.id[lane] = 0U;
    rays.flags[lane] = 0U;
}

/// make_ray(i) -> Ray for i in [0, n); on_hit(i, Hit). Functors may be asked for lanes up to the
/// next multiple of 16 (their views are padded); those rays are not traced and not reported.
template <class MakeRay, class OnHit>
void closest(RTCScene scene, View<const std::uint32_t> first_triangles, int n,
             const MakeRay& make_ray, const OnHit& on_hit) {
    Query query(Coherence::coherent);
    for (int base = 0; base < n; base += kPacket) {
        alignas(64) RTCRayHit16 packet;
        alignas(64) int valid[kPacket];
        const int active = n - base;
#pragma GCC ivdep
        for (int lane = 0; lane < kPacket; ++lane) {
            set_lane(packet.ray, lane, make_ray(base + lane));
            packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
            packet.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
            valid[lane] = lane < active ? -1 : 0;
        }
        query.closest16(valid, scene, packet);
        const int count = active < kPacket ? active : kPacket;
        for (int lane = 0; lane < count; ++lane) {
            Hit hit;
            if (packet.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID)
                hit = {packet.ray.tfar[lane], packet.hit.u[lane], packet.hit.v[lane],
                       first_triangles[packet.hit.geomID[lane]] + packet.hit.primID[lane]};
            on_hit(base + lane, hit);
        }
    }
}

/// make_ray(slot, sample) -> WeightedRay; on_sum(slot, sum of the weights of unoccluded samples).
/// A packet holds `per_packet` samples (a power of two up to 16 that divides `samples`) of 16 /
/// per_packet slots. Returns the number of rays traced.
template <class MakeRay, class OnSum>
std::uint64_t visible(RTCScene scene, int n, int samples, int per_packet, const MakeRay& make_ray,
                      const OnSum& on_sum) {
    Query query(Coherence::coherent);
    std::uint64_t traced = 0;
    const int slots = kPacket / per_packet;
    const int shift = std::countr_zero(static_cast<unsigned>(slots));
    for (int base = 0; base < n; base += slots) {
        const int active = n - base < slots ? n - base : slots;
        alignas(64) float sum[kPacket] = {};
        for (int first = 0; first < samples; first += per_packet) {
            alignas(64) RTCRay16 packet;
            alignas(64) int valid[kPacket];
            alignas(64) float weight[kPacket];
            int count = 0;
#pragma GCC ivdep
            for (int lane = 0; lane < kPacket; ++lane) {
                const int slot = lane & (slots - 1);
                const WeightedRay r = make_ray(base + slot, first + (lane >> shift));
                set_lane(packet, lane, r.ray);
                weight[lane] = r.weight;
                valid[lane] = (slot < active) & (r.weight > 0.0F) ? -1 : 0;
                count -= valid[lane];
            }
            if (count == 0) continue;
            traced += static_cast<std::uint64_t>(count);
            query.occluded16(valid, scene, packet);
            for (int lane = 0; lane < kPacket; ++lane)
                sum[lane] += (valid[lane] != 0) & (packet.tfar[lane] >= 0.0F) ? weight[lane] : 0.0F;
        }
        for (int lane = slots; lane < kPacket; ++lane) sum[lane & (slots - 1)] += sum[lane];
        for (int lane = 0; lane < active; ++lane) on_sum(base + lane, sum[lane]);
    }
    return traced;
}

}  // namespace foverig::embree
