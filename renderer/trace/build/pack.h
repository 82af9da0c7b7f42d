#pragma once
#include "renderer/trace/build/binary_bvh.h"
#include "renderer/trace/packed_bvh.h"

namespace foverig {

/// A wide tree, breadth first: nodes of one level lie together, levels one after the other.
struct WideTree {
    std::vector<WideNode> nodes;
    std::vector<std::uint32_t> level_ends;  ///< number of nodes down to each level
    std::vector<std::uint32_t> primitives;  ///< in the order of the leaves' triangles
};

/// What a primitive of a tree becomes.
enum class Primitives {
    triangles,  ///< of leaves, up to kLeafTriangles in each
    nodes       ///< a child node each, left for the caller to fill in
};

/// Collapses and quantises. Children lie in the slots that stand for their direction from the
/// node's middle, bits 4, 2, 1 for x, y, z upwards (Ylitie 2017). Numbers of nodes and
/// triangles in the nodes count from 0. With Primitives::nodes, `primitives` has an entry for each
/// node: the primitive that it stands for, or kNoPrimitive.
WideTree pack(const BinaryBvh& tree, Primitives become);

inline constexpr std::uint32_t kNoPrimitive = 0xFFFFFFFFU;

}  // namespace foverig
