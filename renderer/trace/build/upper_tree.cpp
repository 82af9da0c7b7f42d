#include "renderer/trace/build/upper_tree.h"

#include <algorithm>

#include "renderer/check.h"
#include "renderer/trace/build/binned_sah.h"
#include "renderer/trace/build/pack.h"
#include "renderer/trace/refit.h"

namespace foverig {
namespace {

constexpr int kSahLevelsOfUpper = 8;

}  // namespace

void UpperTree::add_still(std::uint32_t root, int levels, const Box& box) {
    lowers_.push_back({root, levels, box, {}});
}

void UpperTree::add_moving(std::uint32_t root, int levels, const VertexRun& vertices) {
    lowers_.push_back({root, levels, {}, vertices});
}

int UpperTree::build(View<const vec3> positions_m, View<WideNode> nodes,
                     View<std::uint32_t> roots) const {
    std::vector<Box> boxes;
    for (const Lower& lower : lowers_) {
        Box box = lower.box;
        const VertexRun& run = lower.vertices;
        for (std::uint32_t v = run.first; v < run.first + run.count; ++v)
            if (in_range(positions_m[v])) box.grow(positions_m[v]);
        boxes.push_back(box);
    }
    const WideTree tree = pack(build_binned(boxes, kSahLevelsOfUpper), Primitives::nodes);
    RIG_CHECK(tree.nodes.size() <= capacity_, "{} trees have few nodes above them: {}",
              lowers_.size(), tree.nodes.size());
    std::fill(nodes.begin(), nodes.end(), WideNode{});
    std::fill(roots.begin(), roots.end(), kNoRoot);
    std::copy(tree.nodes.begin(), tree.nodes.end(), nodes.begin());
    int deepest = 0;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        if (tree.primitives[i] == kNoPrimitive) continue;
        const Lower& lower = lowers_[tree.primitives[i]];
        roots[i] = lower.root;
        deepest = std::max(deepest, lower.levels);
    }
    const int levels = static_cast<int>(tree.level_ends.size()) + deepest - 1;
    RIG_CHECK(levels <= kMostLevelsOfNodes, "a traversal's stack holds the longest way: {}",
              levels);
    return levels;
}

}  // namespace foverig
