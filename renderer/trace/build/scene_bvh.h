#pragma once
#include "renderer/scene/scene.h"
#include "renderer/trace/build/binary_bvh.h"
#include "renderer/trace/build/refit_plan.h"

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
    const RefitPlan& plan() const { return plan_; }
    int levels() const { return levels_; }  ///< of nodes on the longest way from the root
    std::uint64_t bytes() const;

  private:
    struct Lower;
    Lower lower_of(std::span<const Part* const> parts, View<const vec3> positions_m,
                   bool alpha_test, const BuildBinary& build) const;
    std::vector<std::uint32_t> append(std::span<const Lower> lowers);
    void plan_refits(std::span<const Lower> moving);

    View<const uvec3> corners_;
    std::vector<WideNode> nodes_;  ///< the upper tree, what stands still, what moves
    std::vector<PackedTriangle> triangles_;
    RefitPlan plan_;
    std::vector<Box> boxes_;       ///< of the nodes that move
    std::vector<WideNode> upper_;  ///< as UpperTree::build leaves them
    std::vector<std::uint32_t> roots_;
    int levels_ = 0;
};

}  // namespace foverig
