#pragma once
// One ray against the boxes of a node's children (Ylitie 2017): eight at a time on
// the host, one after the other on the device.
#include <bit>

#include "renderer/trace/byte_lanes.h"
#include "renderer/trace/slab_frame.h"
#include "renderer/trace/triple.h"

namespace foverig {

/// Bits 24..31: inner children that [t_min, t_max] meets, the soonest to visit highest (bit 24 +
/// (slot ^ flip)). Bits 0..23: triangles of leaves that it meets.
RIG_INLINE std::uint32_t meet_children(const WideNode& node, const SlabFrame& ray, float t_min,
                                       float t_max) {
    float step[3];
    float nearest[3];
    float farthest[3];
    for (int a = 0; a < 3; ++a) {
        const float grid = std::bit_cast<float>(std::uint32_t{node.exponent[a]} << 23U);
        const float begin = rounded_product(node.origin_m[a] - ray.origin_m[a], ray.over[a]);
        step[a] = grid * ray.over[a];
        nearest[a] = begin - ray.pad[a];
        farthest[a] = begin + ray.pad[a];
    }
    std::uint32_t met = 0;
    for (int first = 0; first < kWidth; first += kLanes) {
        Lanes t_in = Lanes{} + t_min;
        Lanes t_out = Lanes{} + t_max;
        for (int a = 0; a < 3; ++a) {
            const Lanes in = to_floats(load_byte_lanes(node.bounds[ray.near_row[a]] + first));
            const Lanes out = to_floats(load_byte_lanes(node.bounds[ray.far_row[a]] + first));
            t_in = max_lanes(fused_lanes(in, step[a], nearest[a]), t_in);
            t_out = min_lanes(fused_lanes(out, step[a], farthest[a]), t_out);
        }
        const LaneInts meta = load_byte_lanes(node.meta + first);
        const LaneInts flip =
            keep_lanes((meta & 24) == 24, LaneInts{} + static_cast<int>(ray.flip));
        const LaneInts bits = (meta >> 5) << ((meta & 31) ^ flip);
        met |= union_of(keep_lanes(t_in <= t_out, bits));
    }
    return met;
}

}  // namespace foverig
