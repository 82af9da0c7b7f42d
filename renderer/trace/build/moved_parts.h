#pragma once
#include <algorithm>

#include "renderer/scene/scene_view.h"
#include "renderer/trace/build/refit_plan.h"

namespace foverig {

/// What a refit takes from outside, packed for the way to another memory.
struct MovedParts {
    View<vec3> positions_m;  ///< of plan.vertices, run after run
    View<vec3> normals;
    View<WideNode> upper;  ///< as UpperTree::build leaves them
    View<std::uint32_t> roots;
};

inline std::size_t moving_vertices(const RefitPlan& plan) {
    std::size_t sum = 0;
    for (const VertexRun& run : plan.vertices) sum += run.count;
    return sum;
}

/// copy(run, place of its first vertex among the packed ones) for each run.
template <class Copy>
void for_each_run(const RefitPlan& plan, const Copy& copy) {
    std::size_t at = 0;
    for (const VertexRun& run : plan.vertices) {
        copy(run, at);
        at += run.count;
    }
}

/// Packs what `posed` has moved. The arrays of `to` are as large as the plan says.
inline void pack_moved(const RefitPlan& plan, const SceneView& posed, const MovedParts& to) {
    for_each_run(plan, [&](const VertexRun& run, std::size_t at) {
        std::copy_n(posed.positions_m.data + run.first, run.count, to.positions_m.data + at);
        std::copy_n(posed.normals.data + run.first, run.count, to.normals.data + at);
    });
    if (plan.moves()) plan.upper.build(posed.positions_m, to.upper, to.roots);
}

}  // namespace foverig
