#pragma once
#include "renderer/scene/scene.h"
#include "renderer/trace/build/binary_bvh.h"
#include "renderer/trace/packed_bvh.h"

namespace foverig {

/// A Scene as one compressed wide BVH in two levels: a tree for all that stands still, a tree for
/// each part that moves, and a small tree over them. The upper tree ends in copies of the lower
/// trees' roots, so to a ray the two levels are one. Triangles with a NaN or a coordinate beyond
/// kFarthest_m are left out.
class SceneBvh {
  public:
    /// `moving_parts`, in rising order, index Scene::parts. `build_still` builds what never moves,
    /// once; moving parts are built without spatial splits, which refitting could not keep. Without
    /// `alpha_test` no triangle has holes.
    SceneBvh(const Scene& scene, View<const vec3> positions_m,
             std::span<const std::size_t> moving_parts, bool alpha_test,
             const BuildBinary& build_still);

    /// Moves the moving parts' boxes to where their vertices are now. Deterministic.
    void refit(View<const vec3> positions_m);

    BvhView view() const;
    int levels() const { return levels_; }  ///< of nodes on the longest way from the root
    std::uint64_t bytes() const;

  private:
    struct Lower {
        std::uint32_t first_node;
        std::uint32_t node_count;
        std::uint32_t first_triangle;
        std::uint32_t triangle_count;
        int levels;
        Box box;
    };
    void add_lower(std::span<const Part* const> parts, View<const vec3> positions_m,
                   bool alpha_test, const BuildBinary& build);
    void refit(Lower& lower, View<const vec3> positions_m);
    void build_upper();

    View<const uvec3> corners_;
    std::size_t upper_capacity_ = 0;  ///< nodes before those of the lower trees
    std::vector<WideNode> nodes_;
    std::vector<PackedTriangle> triangles_;
    std::vector<Box> boxes_;  ///< of nodes from first_moving_node_
    std::size_t first_moving_node_ = 0;
    std::vector<Lower> lowers_;  ///< the one that stands still first, if it holds anything
    std::size_t first_moving_ = 0;
    int levels_ = 0;
};

}  // namespace foverig
