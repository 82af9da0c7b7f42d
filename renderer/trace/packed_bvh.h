#pragma once
// The compressed wide BVH of Ylitie, Karras and Laine 2017 ("Efficient Incoherent Ray Traversal on
// GPUs Through Compressed Wide BVHs"): the layout that host and device read.
#include <bit>
#include <cstdint>

#include "renderer/trace/box.h"
#include "renderer/view.h"

namespace foverig {

inline constexpr int kWidth = 8;                         ///< children of a node
inline constexpr int kLeafTriangles = 3;                 ///< most triangles of a leaf child
inline constexpr std::uint32_t kMaskedBit = 1U << 29U;   ///< in PackedTriangle: has holes
inline constexpr std::uint32_t kNumberBits = 1U << 30U;  ///< makes the number a normal float
/// Levels of nodes; what a traversal stack holds, since a level leaves at most one entry.
inline constexpr int kMostLevelsOfNodes = 64;
/// Triangles with a coordinate not below this, or NaN, are not held (Embree's limit too).
inline constexpr float kFarthest_m = 1.844e18F;

/// 80 bytes. Child boxes are bytes on a grid of the node's own: bound b means
/// origin_m[axis] + b * 2^(exponent[axis] - 127) metres, exponent 0 a step of 0.
struct alignas(16) WideNode {
    float origin_m[3];
    std::uint8_t exponent[3];
    std::uint8_t inner;            ///< bit s: the child in slot s is a node
    std::uint32_t first_child;     ///< its inner children lie there, in order of slots
    std::uint32_t first_triangle;  ///< its leaves' triangles lie there
    /// 0: nothing in this slot. Inner: 32 + 24 + slot. Leaf: the triangle count in unary (1, 3, 7)
    /// in the upper three bits, the first triangle's place among the node's (0..23) in the lower
    /// five.
    std::uint8_t meta[kWidth];
    std::uint8_t bounds[6][kWidth];  ///< rows: min x, y, z, max x, y, z
};
static_assert(sizeof(WideNode) == 80);

/// A triangle by axes: row[a] = coordinate a of the three corners, so that the choice of axes in
/// ray_triangle.h is a choice of rows. row[0][3] holds kNumberBits + kMaskedBit if masked + the
/// triangle's number, which as a float is normal: no denormal slows down the lanes that compute
/// with it.
struct alignas(16) PackedTriangle {
    float row[3][4];
};
static_assert(sizeof(PackedTriangle) == 48);

struct BvhView {
    View<const WideNode> nodes;  ///< nodes[0] is the root; empty: nothing to hit
    View<const PackedTriangle> triangles;
};

/// All that the node's grid reaches, which holds every child's box.
RIG_HD inline Box grid_box(const WideNode& node) {
    Box box;
    for (int a = 0; a < 3; ++a) {
        box.min_m[a] = node.origin_m[a];
        box.max_m[a] = node.origin_m[a] +
                       255.0F * std::bit_cast<float>(std::uint32_t{node.exponent[a]} << 23U);
    }
    return box;
}

}  // namespace foverig
