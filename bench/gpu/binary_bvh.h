#pragma once
#include <algorithm>

#include "bench/gpu/binary_traverse.h"
#include "renderer/check.h"
#include "renderer/trace/build/binary_bvh.h"
#include "renderer/trace/refit.h"

namespace foverig::gpu {

/// The triangles of a packed tree that has no triangle twice, as a plain binary BVH. Subtrees
/// become leaves where the surface area heuristic says so.
class PackedBinary {
  public:
    PackedBinary(View<const PackedTriangle> triangles, const BuildBinary& build)
        : packed_(triangles) {
        std::vector<Corners> corners;
        for (const PackedTriangle& t : triangles) {
            corners.emplace_back();
            for (std::size_t c = 0; c < 3; ++c)
                corners.back()[c] = {t.row[0][c], t.row[1][c], t.row[2][c]};
        }
        RIG_CHECK(corners.size() < kBinaryLeafBit / kMostBinaryLeaf, "a leaf is one number");
        tree_ = build(corners);
        if (tree_.empty()) return;
        choose_leaves();
        bounds_ = tree_[0].box;
        root_ = add(0, 0);
        tree_ = {};
    }

    BinaryView view() const { return {root_, view_of(nodes_), view_of(triangles_), bounds_}; }

  private:
    /// Cost of a triangle's test beside a node's, as the wide tree's collapse has it.
    static constexpr float kTriangleCost = 0.3F;
    static constexpr std::uint32_t kMostInLeaf = 4;

    struct Subtree {
        std::uint32_t triangles;
        float cost;
        bool leaf;
    };

    void choose_leaves() {
        subtrees_.resize(tree_.size());
        for (std::size_t i = tree_.size(); i-- > 0;) {
            const float area_m2 = tree_[i].box.half_area_m2();
            if (tree_[i].leaf()) {
                subtrees_[i] = {1, area_m2 * kTriangleCost, true};
                continue;
            }
            const Subtree& left = subtrees_[tree_[i].first_child];
            const Subtree& right = subtrees_[tree_[i].first_child + 1];
            const std::uint32_t count = left.triangles + right.triangles;
            const float as_leaf = area_m2 * kTriangleCost * static_cast<float>(count);
            const float as_node = area_m2 + left.cost + right.cost;
            const bool leaf = count <= kMostInLeaf && as_leaf <= as_node;
            subtrees_[i] = {count, leaf ? as_leaf : as_node, leaf};
        }
    }

    /// Depth first: a node's first child, unless a leaf, follows it.
    std::uint32_t add(std::uint32_t binary, int level) {
        RIG_CHECK(level < kMostBinaryLevels, "a traversal's stack holds the longest way: {}",
                  level);
        if (subtrees_[binary].leaf) {
            const auto first = static_cast<std::uint32_t>(triangles_.size());
            add_triangles(binary);
            return kBinaryLeafBit + first * kMostBinaryLeaf + subtrees_[binary].triangles - 1U;
        }
        const std::size_t at = nodes_.size();
        nodes_.emplace_back();
        for (std::uint32_t c = 0; c < 2; ++c) {
            const std::uint32_t child = tree_[binary].first_child + c;
            const std::uint32_t place = add(child, level + 1);
            PairNode& node = nodes_[at];
            node.child[c] = place;
            for (int a = 0; a < 3; ++a) {
                node.min_m[c][a] = tree_[child].box.min_m[a];
                node.max_m[c][a] = tree_[child].box.max_m[a];
            }
        }
        return static_cast<std::uint32_t>(at);
    }
    void add_triangles(std::uint32_t binary) {
        if (tree_[binary].leaf()) return triangles_.push_back(packed_[tree_[binary].primitive]);
        add_triangles(tree_[binary].first_child);
        add_triangles(tree_[binary].first_child + 1);
    }

    View<const PackedTriangle> packed_;
    BinaryBvh tree_;
    std::vector<Subtree> subtrees_;
    std::vector<PairNode> nodes_;
    std::vector<PackedTriangle> triangles_;
    Box bounds_;
    std::uint32_t root_ = 0;
};

}  // namespace foverig::gpu
