#pragma once
// New boxes for a tree whose triangles have moved: the same tree, so the same order of work and the
// same bytes on any number of threads. Nodes of one level may be done in any order, levels from the
// deepest to the root.
#include <bit>

#include "renderer/trace/quantise.h"

namespace foverig {

RIG_HD inline std::uint32_t number_of(const PackedTriangle& triangle) {
    return std::bit_cast<std::uint32_t>(triangle.row[0][3]) & (kMaskedBit - 1U);
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

    RIG_HD void operator()(int i) const {
        PackedTriangle& triangle = triangles[static_cast<std::size_t>(i)];
        const uvec3 c = corners[number_of(triangle)];
        const vec3 at[3] = {positions_m[c.x], positions_m[c.y], positions_m[c.z]};
        bool held = true;
        for (const vec3& p : at)
            for (int a = 0; a < 3; ++a) held = held && p[a] < kFarthest_m && p[a] > -kFarthest_m;
        for (int a = 0; a < 3; ++a)
            for (int corner = 0; corner < 3; ++corner)
                triangle.row[a][corner] =
                    held ? at[corner][a] : std::numeric_limits<float>::quiet_NaN();
    }
};

struct RefitNodes {
    View<WideNode> nodes;
    View<Box> boxes;  ///< by node
    View<const PackedTriangle> triangles;

    RIG_HD void operator()(int i) const {
        WideNode& node = nodes[static_cast<std::size_t>(i)];
        Box children[kWidth];
        std::uint32_t child = node.first_child;
        for (std::uint32_t slot = 0; slot < kWidth; ++slot) {
            if ((node.inner >> slot & 1U) != 0U) {
                children[slot] = boxes[child++];
                continue;
            }
            const std::uint32_t meta = node.meta[slot];
            const std::uint32_t first = node.first_triangle + (meta & 31U);
            const auto count = static_cast<std::uint32_t>(std::popcount(meta >> 5U));
            for (std::uint32_t k = 0; k < count; ++k)
                children[slot].grow(box_of(triangles[first + k]));
        }
        set_boxes(node, children);
        Box all;
        for (const Box& box : children) all.grow(box);
        boxes[static_cast<std::size_t>(i)] = all;
    }
};

}  // namespace foverig
