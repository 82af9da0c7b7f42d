#include "renderer/trace/build/scene_bvh.h"

#include <algorithm>
#include <bit>

#include "renderer/check.h"
#include "renderer/trace/build/binned_sah.h"
#include "renderer/trace/build/pack.h"
#include "renderer/trace/refit.h"

namespace foverig {
namespace {

/// The longest way through a lower tree, and what is left for the upper one.
constexpr std::size_t kLowerLevels = 40;

bool all_in_range(const Corners& corners) {
    return in_range(corners[0]) && in_range(corners[1]) && in_range(corners[2]);
}

PackedTriangle packed(const Corners& corners, std::uint32_t number, bool masked) {
    PackedTriangle t;
    for (int a = 0; a < 3; ++a)
        for (int corner = 0; corner < 3; ++corner)
            t.row[a][corner] = corners[static_cast<std::size_t>(corner)][a];
    t.row[0][3] = std::bit_cast<float>(kNumberBits + (masked ? kMaskedBit : 0U) + number);
    t.row[1][3] = t.row[2][3] = 0.0F;
    return t;
}

/// Trees of unlucky geometry can be too deep; halves never are.
WideTree packed_tree(std::span<const Corners> corners, const BuildBinary& build) {
    WideTree tree = pack(build(corners), Primitives::triangles);
    if (tree.level_ends.size() <= kLowerLevels) return tree;
    std::vector<Box> boxes;
    for (const Corners& c : corners) boxes.push_back(box_of(c));
    return pack(build_binned(boxes, 0), Primitives::triangles);
}

}  // namespace

/// A tree whose numbers of nodes and triangles count from 0.
struct SceneBvh::Lower {
    WideTree tree;
    std::vector<PackedTriangle> triangles;
    Box box;
    VertexRun vertices;  ///< of the part that moves

    int levels() const { return static_cast<int>(tree.level_ends.size()); }
    std::uint32_t nodes_on(std::size_t level) const {
        if (level >= tree.level_ends.size()) return 0;
        return tree.level_ends[level] - (level == 0 ? 0U : tree.level_ends[level - 1]);
    }
};

SceneBvh::SceneBvh(const Scene& scene, View<const vec3> positions_m,
                   std::span<const std::size_t> moving_parts, bool alpha_test,
                   const BuildBinary& build_still)
    : corners_(view_of(scene.triangles)) {
    RIG_CHECK(scene.triangles.size() < kMaskedBit, "a triangle's number fits into its tag");
    std::vector<const Part*> still_parts;
    std::vector<Lower> moving;
    std::size_t found = 0;
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        const Part* const part = &scene.parts[i];
        if (found == moving_parts.size() || moving_parts[found] != i) {
            still_parts.push_back(part);
            continue;
        }
        ++found;
        Lower lower = lower_of({&part, 1}, positions_m, alpha_test, build_binned_triangles);
        lower.vertices = {part->first_vertex, part->vertex_count};
        if (lower.levels() > 0) moving.push_back(std::move(lower));
    }
    const Lower still = lower_of(still_parts, positions_m, alpha_test, build_still);
    if (!moving.empty()) plan_.upper.reserve(moving.size());
    nodes_.resize(plan_.upper.capacity());
    levels_ = still.levels();
    if (levels_ > 0)
        plan_.upper.add_still(static_cast<std::uint32_t>(nodes_.size()), levels_, still.box);
    append({&still, 1});
    if (moving.empty()) return;
    plan_refits(moving);
    refit(positions_m);
}

SceneBvh::Lower SceneBvh::lower_of(std::span<const Part* const> parts, View<const vec3> positions_m,
                                   bool alpha_test, const BuildBinary& build) const {
    std::vector<Corners> corners;
    std::vector<std::uint32_t> numbers;
    std::vector<bool> masked;
    Lower lower;
    for (const Part* part : parts) {
        for (std::uint32_t i = 0; i < part->triangle_count; ++i) {
            const std::uint32_t number = part->first_triangle + i;
            const uvec3 c = corners_[number];
            const Corners at{positions_m[c.x], positions_m[c.y], positions_m[c.z]};
            if (!all_in_range(at)) continue;
            corners.push_back(at);
            numbers.push_back(number);
            masked.push_back(part->alpha_masked && alpha_test);
            lower.box.grow(box_of(at));
        }
    }
    if (corners.empty()) return lower;
    lower.tree = packed_tree(corners, build);
    lower.triangles.reserve(lower.tree.primitives.size());
    for (const std::uint32_t p : lower.tree.primitives)
        lower.triangles.push_back(packed(corners[p], numbers[p], masked[p]));
    return lower;
}

/// Level by level, so that a level of all trees is one range of nodes. Returns the levels' ends.
std::vector<std::uint32_t> SceneBvh::append(std::span<const Lower> lowers) {
    std::vector<std::uint32_t> first_triangle;
    std::size_t deepest = 0;
    for (const Lower& lower : lowers) {
        first_triangle.push_back(static_cast<std::uint32_t>(triangles_.size()));
        triangles_.insert(triangles_.end(), lower.triangles.begin(), lower.triangles.end());
        deepest = std::max(deepest, lower.tree.level_ends.size());
    }
    std::vector<std::uint32_t> level_ends;
    for (std::size_t level = 0; level < deepest; ++level) {
        auto end = static_cast<std::uint32_t>(nodes_.size());
        for (const Lower& lower : lowers) end += lower.nodes_on(level);
        std::uint32_t child = end;  // where the next tree's children of this level begin
        for (std::size_t i = 0; i < lowers.size(); ++i) {
            if (lowers[i].nodes_on(level) == 0) continue;
            const WideTree& tree = lowers[i].tree;
            const std::uint32_t tree_end = tree.level_ends[level];
            for (std::uint32_t n = tree_end - lowers[i].nodes_on(level); n < tree_end; ++n) {
                WideNode node = tree.nodes[n];
                node.first_child += child - tree_end;
                node.first_triangle += first_triangle[i];
                nodes_.push_back(node);
            }
            child += lowers[i].nodes_on(level + 1);
        }
        level_ends.push_back(end);
    }
    return level_ends;
}

void SceneBvh::plan_refits(std::span<const Lower> moving) {
    plan_.first_node = static_cast<std::uint32_t>(nodes_.size());
    plan_.first_triangle = static_cast<std::uint32_t>(triangles_.size());
    for (std::size_t i = 0; i < moving.size(); ++i) {
        const VertexRun& run = moving[i].vertices;
        plan_.upper.add_moving(plan_.first_node + static_cast<std::uint32_t>(i), moving[i].levels(),
                               run);
        std::vector<VertexRun>& runs = plan_.vertices;
        if (!runs.empty() && runs.back().first + runs.back().count == run.first)
            runs.back().count += run.count;
        else
            runs.push_back(run);
    }
    plan_.level_ends = append(moving);
    plan_.triangle_count = static_cast<std::uint32_t>(triangles_.size()) - plan_.first_triangle;
    boxes_.resize(plan_.node_count());
    upper_.resize(plan_.upper.capacity());
    roots_.resize(plan_.upper.capacity());
}

void SceneBvh::refit(View<const vec3> positions_m) {
    if (!plan_.moves()) return;
    levels_ = plan_.upper.build(positions_m, view_of(upper_), view_of(roots_));
    refit_passes(plan_,
                 {positions_m, corners_, view_of(nodes_), view_of(triangles_), view_of(boxes_),
                  view_of(upper_), view_of(roots_)},
                 [](const char* /*name*/, int n, const auto& kernel) {
                     for (int i = 0; i < n; ++i) kernel(i);
                 });
}

BvhView SceneBvh::view() const {
    return {view_of(nodes_), view_of(triangles_)};
}

std::uint64_t SceneBvh::bytes() const {
    const auto of = [](const auto& v) { return v.capacity() * sizeof v[0]; };
    return of(nodes_) + of(triangles_) + of(boxes_) + of(upper_) + of(roots_);
}

}  // namespace foverig
