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
constexpr int kUpperSahLevels = 8;

bool in_range(const Corners& corners) {
    for (const vec3& p : corners)
        for (int a = 0; a < 3; ++a)
            if (!(p[a] < kFarthest_m && p[a] > -kFarthest_m)) return false;
    return true;
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

SceneBvh::SceneBvh(const Scene& scene, View<const vec3> positions_m,
                   std::span<const std::size_t> moving_parts, bool alpha_test,
                   const BuildBinary& build_still)
    : corners_(view_of(scene.triangles)) {
    RIG_CHECK(scene.triangles.size() < kMaskedBit, "a triangle's number fits into its tag");
    std::vector<const Part*> still;
    std::vector<const Part*> moving;
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        const bool moves = moving.size() < moving_parts.size() && moving_parts[moving.size()] == i;
        (moves ? moving : still).push_back(&scene.parts[i]);
    }
    upper_capacity_ = moving.empty() ? 0 : 2 * (moving.size() + 1);
    nodes_.resize(upper_capacity_);
    add_lower(still, positions_m, alpha_test, build_still);
    first_moving_ = lowers_.size();
    first_moving_node_ = nodes_.size();
    for (const Part* part : moving)
        add_lower({&part, 1}, positions_m, alpha_test, build_binned_triangles);
    boxes_.resize(nodes_.size() - first_moving_node_);
    for (const Lower& lower : lowers_) levels_ = std::max(levels_, lower.levels);
    if (!moving.empty()) refit(positions_m);
    RIG_CHECK(levels_ <= kMostLevelsOfNodes, "a traversal's stack holds the longest way: {}",
              levels_);
}

void SceneBvh::add_lower(std::span<const Part* const> parts, View<const vec3> positions_m,
                         bool alpha_test, const BuildBinary& build) {
    std::vector<Corners> corners;
    std::vector<std::uint32_t> numbers;
    std::vector<bool> masked;
    for (const Part* part : parts) {
        for (std::uint32_t i = 0; i < part->triangle_count; ++i) {
            const std::uint32_t number = part->first_triangle + i;
            const uvec3 c = corners_[number];
            const Corners at{positions_m[c.x], positions_m[c.y], positions_m[c.z]};
            if (!in_range(at)) continue;
            corners.push_back(at);
            numbers.push_back(number);
            masked.push_back(part->alpha_masked && alpha_test);
        }
    }
    if (corners.empty()) return;
    const WideTree tree = packed_tree(corners, build);
    Lower lower{static_cast<std::uint32_t>(nodes_.size()),
                static_cast<std::uint32_t>(tree.nodes.size()),
                static_cast<std::uint32_t>(triangles_.size()),
                static_cast<std::uint32_t>(tree.primitives.size()),
                static_cast<int>(tree.level_ends.size()),
                {}};
    for (const Corners& at : corners) lower.box.grow(box_of(at));
    for (const std::uint32_t p : tree.primitives)
        triangles_.push_back(packed(corners[p], numbers[p], masked[p]));
    for (WideNode node : tree.nodes) {
        node.first_child += lower.first_node;
        node.first_triangle += lower.first_triangle;
        nodes_.push_back(node);
    }
    lowers_.push_back(lower);
}

void SceneBvh::refit(View<const vec3> positions_m) {
    for (std::size_t i = first_moving_; i < lowers_.size(); ++i) refit(lowers_[i], positions_m);
    if (upper_capacity_ > 0) build_upper();
}

void SceneBvh::refit(Lower& lower, View<const vec3> positions_m) {
    const View<PackedTriangle> triangles = view_of(triangles_);
    const MoveTriangles move{
        positions_m, corners_, {triangles.data + lower.first_triangle, lower.triangle_count}};
    for (std::uint32_t i = 0; i < lower.triangle_count; ++i) move(static_cast<int>(i));
    const View<Box> boxes{boxes_.data() - first_moving_node_, nodes_.size()};
    const RefitNodes refit_node{view_of(nodes_), boxes, triangles};
    for (std::uint32_t i = lower.node_count; i-- > 0;)
        refit_node(static_cast<int>(lower.first_node + i));
    lower.box = boxes[lower.first_node];
}

void SceneBvh::build_upper() {
    std::vector<Box> boxes;
    for (const Lower& lower : lowers_) boxes.push_back(lower.box);
    const WideTree tree = pack(build_binned(boxes, kUpperSahLevels), Primitives::nodes);
    RIG_CHECK(tree.nodes.size() <= upper_capacity_, "{} trees have few nodes above them: {}",
              lowers_.size(), tree.nodes.size());
    int deepest = 0;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const std::uint32_t p = tree.primitives[i];
        nodes_[i] = p == kNoPrimitive ? tree.nodes[i] : nodes_[lowers_[p].first_node];
        if (p != kNoPrimitive) deepest = std::max(deepest, lowers_[p].levels);
    }
    levels_ = static_cast<int>(tree.level_ends.size()) + deepest - 1;
}

BvhView SceneBvh::view() const {
    if (lowers_.empty()) return {};
    Box all;
    for (const Lower& lower : lowers_) all.grow(lower.box);
    return {view_of(nodes_), view_of(triangles_), all};
}

std::uint64_t SceneBvh::bytes() const {
    return nodes_.capacity() * sizeof(WideNode) + triangles_.capacity() * sizeof(PackedTriangle) +
           boxes_.capacity() * sizeof(Box);
}

}  // namespace foverig
