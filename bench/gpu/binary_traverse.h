#pragma once
// What the compressed wide BVH is measured against: a plain binary BVH, two float boxes a node,
// nearer child first (Aila and Laine 2009), with the wide tree's triangle test and promises. For
// host and device.
#include "renderer/trace/traverse.h"

namespace foverig::gpu {

inline constexpr std::uint32_t kBinaryLeafBit = 1U << 31U;
inline constexpr std::uint32_t kMostBinaryLeaf = 8;  ///< triangles of a leaf
inline constexpr int kMostBinaryLevels = 100;        ///< what a traversal's stack holds

/// 64 bytes, one load of a node for both children.
struct alignas(16) PairNode {
    float min_m[2][3];
    float max_m[2][3];
    /// A node's place, or kBinaryLeafBit + 8 times the first triangle's + their number - 1.
    std::uint32_t child[2];
    std::uint32_t unused[2];
};
static_assert(sizeof(PairNode) == 64);

struct BinaryView {
    std::uint32_t root = 0;  ///< as PairNode::child
    View<const PairNode> nodes;
    View<const PackedTriangle> triangles;  ///< empty: nothing to hit
    Box bounds;
};

/// A ray as float boxes see it: t of a plane is one fused step from it. Padded as SlabFrame is, and
/// for the rounding of the origin's own term too.
struct PairFrame {
    float over[3];
    float nearest[3];
    float farthest[3];
    std::uint32_t backward[3];

    RIG_HD PairFrame(const Ray& ray, const SlabFrame& slabs) {
        for (int a = 0; a < 3; ++a) {
            over[a] = slabs.over[a];
            const float begin = -ray.origin_m[a] * over[a];
            const float pad = slabs.pad[a] + 9.5367431640625e-7F * (begin < 0.0F ? -begin : begin);
            nearest[a] = begin - pad;
            farthest[a] = begin + pad;
            backward[a] = ray.direction[a] < 0.0F ? 1U : 0U;
        }
    }
    /// Where the ray enters the child's box; infinity where it does not.
    RIG_INLINE float entry(const PairNode& node, int c, float t_min, float t_max) const {
        for (int a = 0; a < 3; ++a) {
            const float low = node.min_m[c][a];
            const float high = node.max_m[c][a];
            const bool back = backward[a] != 0U;
            t_min = max_of(__builtin_fmaf(back ? high : low, over[a], nearest[a]), t_min);
            t_max = min_of(__builtin_fmaf(back ? low : high, over[a], farthest[a]), t_max);
        }
        return t_min <= t_max ? t_min : std::numeric_limits<float>::infinity();
    }
};

/// As foverig::traverse.
template <bool kAny, bool kAlpha, class Count = Uncounted>
RIG_INLINE Hit traverse_binary(const BinaryView& bvh, const SceneView& scene, const Ray& ray,
                               Count&& count = Count{}) {
    Hit best;
    best.t = ray.t_max;
    SlabFrame slabs;
    if (bvh.triangles.empty() || !make_slab_frame(ray, bvh.bounds, slabs)) return best;
    const PairFrame frame(ray, slabs);
    const ShearFrame shear(ray);
    std::uint32_t stack[kMostBinaryLevels];
    int held = 0;
    std::uint32_t at = bvh.root;
    while (true) {
        bool pop = true;
        if ((at & kBinaryLeafBit) == 0U) {
            const PairNode& node = bvh.nodes[at];
            count.node();
            const float t_0 = frame.entry(node, 0, ray.t_min, best.t);
            const float t_1 = frame.entry(node, 1, ray.t_min, best.t);
            const bool meets_0 = t_0 <= best.t;
            const bool meets_1 = t_1 <= best.t;
            const int nearer = meets_1 && !(meets_0 && t_0 <= t_1) ? 1 : 0;
            if (meets_0 && meets_1) stack[held++] = node.child[1 - nearer];
            at = node.child[nearer];
            pop = !meets_0 && !meets_1;
        } else {
            const std::uint32_t first = (at & ~kBinaryLeafBit) / kMostBinaryLeaf;
            for (std::uint32_t i = first; i <= first + at % kMostBinaryLeaf; ++i) {
                count.triangle();
                const bool taken =
                    take_triangle<kAny, kAlpha>(bvh.triangles[i], shear, scene, ray.t_min, best);
                if (kAny && taken) return best;
            }
        }
        if (!pop) continue;
        if (held == 0) return best;
        at = stack[--held];
    }
}

}  // namespace foverig::gpu
