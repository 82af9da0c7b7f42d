#pragma once
// Depth-first, in the order of the ray, with a stack of node groups (Ylitie 2017).
#include <bit>

#include "renderer/kernels/alpha_test.h"
#include "renderer/trace/node_test.h"
#include "renderer/trace/ray_triangle.h"

namespace foverig {

/// Children of one node that are still to visit: bits 24..31 of `met` as meet_children gives them,
/// bits 0..7 the node's `inner`.
struct NodeGroup {
    std::uint32_t first_child;
    std::uint32_t met;

    RIG_HD bool empty() const { return met < (1U << 24U); }
    /// Takes the soonest out and returns its node.
    RIG_HD std::uint32_t take(std::uint32_t flip) {
        const auto bit = static_cast<std::uint32_t>(std::bit_width(met)) - 1U;
        met &= ~(1U << bit);
        const std::uint32_t slot = (bit - 24U) ^ flip;
        const std::uint32_t before = met & 255U & ((1U << slot) - 1U);
        return first_child + static_cast<std::uint32_t>(std::popcount(before));
    }
};

/// Where nobody counts what a ray costs.
struct Uncounted {
    RIG_HD void node() const {}
    RIG_HD void triangle() const {}
};

/// Whether the ray meets the triangle before `best`, or at its t with a lower number; then it
/// becomes `best`. With kAny some hit is as good as another.
template <bool kAny, bool kAlpha>
RIG_INLINE bool take_triangle(const PackedTriangle& triangle, const ShearFrame& shear,
                              const SceneView& scene, float t_min, Hit& best) {
    const TriangleHit hit = intersect(shear, triangle);
    if (!(hit.t >= t_min && hit.t <= best.t)) return false;
    const std::uint32_t tag = std::bit_cast<std::uint32_t>(triangle.row[0][3]);
    const std::uint32_t number = tag & (kMaskedBit - 1U);
    if (!kAny && hit.t == best.t && number > best.triangle) return false;
    if constexpr (kAlpha)
        if ((tag & kMaskedBit) != 0U && is_hole(scene, number, hit.v, hit.w)) return false;
    best = {hit.t, hit.v, hit.w, number};
    return true;
}

/// The hit with the smallest t in [t_min, t_max], of several the lowest triangle number; with kAny
/// some hit. kAlpha: texels below a masked triangle's cutoff are holes (`scene` is read for them
/// alone). `count` is told of each node and triangle that is tested.
template <bool kAny, bool kAlpha, class Count = Uncounted>
RIG_INLINE Hit traverse(const BvhView& bvh, const SceneView& scene, const Ray& ray,
                        Count&& count = Count{}) {
    Hit best;
    best.t = ray.t_max;
    SlabFrame slabs;
    if (bvh.nodes.empty() || !make_slab_frame(ray, grid_box(bvh.nodes[0]), slabs)) return best;
    // Where any hit will do, farther children first: on its way off a surface a ray passes much of
    // what lies close by, and seldom what lies far away.
    if (kAny) slabs.flip ^= 7U;
    const ShearFrame shear(ray);
    NodeGroup stack[kMostLevelsOfNodes];
    int held = 0;
    NodeGroup group{0U, (1U << 24U << slabs.flip) | 1U};  // the root, as if in slot 0
    while (true) {
        const std::uint32_t at = group.take(slabs.flip);
        if (!group.empty()) stack[held++] = group;
        const WideNode& node = bvh.nodes[at];
        count.node();
        const std::uint32_t met = meet_children(node, slabs, ray.t_min, best.t);
        group = {node.first_child, (met & 0xFF000000U) | node.inner};
        for (std::uint32_t left = met & 0x00FFFFFFU; left != 0U; left &= left - 1U) {
            count.triangle();
            const bool taken = take_triangle<kAny, kAlpha>(
                bvh.triangles[node.first_triangle +
                              static_cast<std::uint32_t>(std::countr_zero(left))],
                shear, scene, ray.t_min, best);
            if (kAny && taken) return best;
        }
        if (group.empty()) {
            if (held == 0) return best;
            group = stack[--held];
        }
    }
}

}  // namespace foverig
