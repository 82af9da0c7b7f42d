#pragma once
// New boxes for a tree whose triangles have moved: the same tree, so the same order of work and the
// same bytes on any number of threads, of host or device. What of a refit follows on what:
// refit_plan.h.
#include <bit>

#include "renderer/trace/quantise.h"

namespace foverig {

RIG_HD inline std::uint32_t number_of(const PackedTriangle& triangle) {
    return std::bit_cast<std::uint32_t>(triangle.row[0][3]) & (kMaskedBit - 1U);
}

RIG_HD inline bool in_range(const vec3& p) {
    for (int a = 0; a < 3; ++a)
        if (!(p[a] < kFarthest_m && p[a] > -kFarthest_m)) return false;
    return true;
}

/// Box of the triangle; empty of one that is not held.
RIG_HD inline Box box_of(const PackedTriangle& triangle) {
    Box box;
    for (int corner = 0; corner < 3; ++corner)
        box.grow({triangle.row[0][corner], triangle.row[1][corner], triangle.row[2][corner]});
    return box;
}

/// Corner positions of triangle i, in place. One that leaves the range becomes NaN, which no ray
/// meets.
struct MoveTriangles {
    View<const vec3> positions_m;
    View<const uvec3> corners;  ///< by triangle number
    View<PackedTriangle> triangles;
    std::uint32_t first;  ///< of those that move

    RIG_HD void operator()(int i) const {
        PackedTriangle triangle = triangles[first + static_cast<std::uint32_t>(i)];
        const uvec3 c = corners[number_of(triangle)];
        const vec3 at[3] = {positions_m[c.x], positions_m[c.y], positions_m[c.z]};
        const bool held = in_range(at[0]) && in_range(at[1]) && in_range(at[2]);
        for (int a = 0; a < 3; ++a)
            for (int corner = 0; corner < 3; ++corner)
                triangle.row[a][corner] =
                    held ? at[corner][a] : std::numeric_limits<float>::quiet_NaN();
        triangles[first + static_cast<std::uint32_t>(i)] = triangle;
    }
};

/// Boxes of the children of node first + i, and its own. Of one level, in any order; its inner
/// children have been done.
struct RefitNodes {
    View<WideNode> nodes;
    View<Box> boxes;  ///< of the nodes from first_moving on
    View<const PackedTriangle> triangles;
    std::uint32_t first_moving;
    std::uint32_t first;

    RIG_HD void operator()(int i) const {
        const std::uint32_t at = first + static_cast<std::uint32_t>(i);
        WideNode node = nodes[at];
        Box children[kWidth];
        std::uint32_t child = node.first_child - first_moving;
        for (std::uint32_t slot = 0; slot < kWidth; ++slot) {
            if ((node.inner >> slot & 1U) != 0U) {
                children[slot] = boxes[child++];
                continue;
            }
            const std::uint32_t meta = node.meta[slot];
            const std::uint32_t begin = node.first_triangle + (meta & 31U);
            const auto count = static_cast<std::uint32_t>(std::popcount(meta >> 5U));
            for (std::uint32_t k = 0; k < count; ++k)
                children[slot].grow(box_of(triangles[begin + k]));
        }
        set_boxes(node, children);
        nodes[at] = node;
        Box all;
        for (const Box& box : children) all.grow(box);
        boxes[at - first_moving] = all;
    }
};

inline constexpr std::uint32_t kNoRoot = 0xFFFFFFFFU;

/// Node i of the upper tree: its own, or a copy of the root that it stands for. After the roots.
struct PlaceUpperNodes {
    View<WideNode> nodes;
    View<const WideNode> upper;
    View<const std::uint32_t> roots;  ///< kNoRoot where the node is the upper tree's own

    RIG_HD void operator()(int i) const {
        const auto at = static_cast<std::size_t>(i);
        nodes[at] = roots[at] == kNoRoot ? upper[at] : nodes[roots[at]];
    }
};

}  // namespace foverig
