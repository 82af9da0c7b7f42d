#pragma once
#include <cstddef>
#include <vector>

#include "renderer/trace/packed_bvh.h"

namespace foverig {

struct VertexRun {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// The small tree over a scene's lower ones (decision 6). It lies before them in the same array and
/// is built anew, on the host, whenever their boxes have changed.
class UpperTree {
  public:
    /// What never moves.
    void add_still(std::uint32_t root, int levels, const Box& box);
    /// A part whose box is that of its vertices.
    void add_moving(std::uint32_t root, int levels, const VertexRun& vertices);

    /// Nodes that are kept for it: at least as many as it ever has. 0 until something moves.
    void reserve(std::size_t moving_parts) { capacity_ = 2 * (moving_parts + 1); }
    std::size_t capacity() const { return capacity_; }

    /// Fills `nodes` and `roots`, `capacity` of each, as PlaceUpperNodes takes them. Returns the
    /// nodes on the longest way through both levels.
    int build(View<const vec3> positions_m, View<WideNode> nodes, View<std::uint32_t> roots) const;

  private:
    struct Lower {
        std::uint32_t root;
        int levels;
        Box box;             ///< of what stands still
        VertexRun vertices;  ///< else
    };
    std::vector<Lower> lowers_;
    std::size_t capacity_ = 0;
};

}  // namespace foverig
