#pragma once
// A ray as boxes are tested with it. Boxes are padded by what rounding can move anything: with e =
// 2^-24 and L the largest coordinate difference of the ray's origin and the scene, ray_triangle.h
// moves corners by at most 6 e L, and a slab's distance is off by at most 5 e L over the direction.
// So whatever the triangle test would hit, the box tests let through.
#include <cstdint>

#include "renderer/trace/packed_bvh.h"
#include "renderer/trace/ray.h"

namespace foverig {

struct SlabFrame {
    float over[3];  ///< 1 / direction, never infinite
    float origin_m[3];
    float pad[3];     ///< 16 e L |1 / direction|
    int near_row[3];  ///< of WideNode::bounds
    int far_row[3];
    std::uint32_t flip;  ///< slot ^ flip: the higher, the sooner to visit (packed_bvh.h's slots)
};

/// False where the ray cannot be traced, which is then a miss: a NaN, no direction, or numbers
/// beyond 2^60.
RIG_HD inline bool make_slab_frame(const Ray& ray, const Box& bounds, SlabFrame& f) {
    constexpr float kLargest = 1.152921504606846976e18F;  // 2^60
    const vec3 size = glm::abs(ray.direction);
    const float longest = max_of(size.x, max_of(size.y, size.z));
    float reach_m = 0.0F;
    for (int a = 0; a < 3; ++a) {
        const float o = ray.origin_m[a];
        reach_m = max_of(reach_m, max_of(bounds.max_m[a] - o, o - bounds.min_m[a]));
        if (!(size[a] <= kLargest) || !(o <= kLargest && o >= -kLargest)) return false;
    }
    if (!(longest >= 1.0F / kLargest)) return false;
    // Over its way through the scene a slope below 2^-40 moves a ray by less than the pad.
    const float least = longest * 9.094947017729282e-13F;
    f.flip = 0;
    for (int a = 0; a < 3; ++a) {
        const bool backward = ray.direction[a] < 0.0F;
        const float slope = max_of(size[a], least);
        f.over[a] = 1.0F / (backward ? -slope : slope);
        f.origin_m[a] = ray.origin_m[a];
        f.pad[a] = 9.5367431640625e-7F * reach_m / slope;
        f.near_row[a] = backward ? 3 + a : a;
        f.far_row[a] = backward ? a : 3 + a;
        if (!backward) f.flip |= 4U >> static_cast<unsigned>(a);
    }
    return true;
}

}  // namespace foverig
