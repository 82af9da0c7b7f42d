#pragma once
// What can move in a packed tree, and the passes of its refit in their order, for host and device.
#include <vector>

#include "renderer/trace/build/upper_tree.h"
#include "renderer/trace/refit.h"

namespace foverig {

/// Fixed when the tree is built. Moving triangles and nodes are the last of their arrays; the nodes
/// lie level by level, each level that of all moving parts together.
struct RefitPlan {
    std::uint32_t first_triangle = 0;
    std::uint32_t triangle_count = 0;
    std::uint32_t first_node = 0;
    std::vector<std::uint32_t> level_ends;  ///< node after each level, the roots' first
    std::vector<VertexRun> vertices;        ///< of all moving parts, neighbours joined
    UpperTree upper;

    bool moves() const { return !level_ends.empty(); }
    std::uint32_t node_count() const { return moves() ? level_ends.back() - first_node : 0; }
};

/// The arrays of one refit: all the host's, or all the device's.
struct RefitArrays {
    View<const vec3> positions_m;
    View<const uvec3> corners;
    View<WideNode> nodes;
    View<PackedTriangle> triangles;
    View<Box> boxes;                  ///< of moving nodes; need not be kept between refits
    View<const WideNode> upper;       ///< as UpperTree::build leaves them, `capacity` of each
    View<const std::uint32_t> roots;  ///< -"-
};

/// launch(name, n, kernel) runs kernel(i) for i in [0, n) in any order, and after the launch before
/// it. The same launches at each refit.
template <class Launch>
void refit_passes(const RefitPlan& plan, const RefitArrays& a, const Launch& launch) {
    if (!plan.moves()) return;
    launch("refit_triangles", static_cast<int>(plan.triangle_count),
           MoveTriangles{a.positions_m, a.corners, a.triangles, plan.first_triangle});
    for (std::size_t level = plan.level_ends.size(); level-- > 0;) {
        const std::uint32_t first = level == 0 ? plan.first_node : plan.level_ends[level - 1];
        launch("refit_nodes", static_cast<int>(plan.level_ends[level] - first),
               RefitNodes{a.nodes, a.boxes, a.triangles, plan.first_node, first});
    }
    launch("refit_upper", static_cast<int>(plan.upper.capacity()),
           PlaceUpperNodes{a.nodes, a.upper, a.roots});
}

}  // namespace foverig
