#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "renderer/trace/box.h"

namespace foverig {

/// A node holds two children or one primitive.
struct BinaryNode {
    Box box;
    std::uint32_t first_child = 0;  ///< the other is next to it; 0: a leaf
    std::uint32_t primitive = 0;    ///< of a leaf

    bool leaf() const { return first_child == 0; }
};

/// The root comes first and parents before their children. Empty: nothing to hold. With spatial
/// splits a primitive has several leaves, whose boxes together hold it.
using BinaryBvh = std::vector<BinaryNode>;

using Corners = std::array<vec3, 3>;

/// Builds over triangles with finite corners; primitive i is triangle i.
using BuildBinary = std::function<BinaryBvh(std::span<const Corners>)>;

inline Box box_of(const Corners& corners) {
    Box box;
    for (const vec3& p : corners) box.grow(p);
    return box;
}

}  // namespace foverig
