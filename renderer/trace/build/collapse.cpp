#include "renderer/trace/build/collapse.h"

#include <algorithm>

namespace foverig {
namespace {

/// Cost of a triangle's test beside a node's. From 0.15 to 0.6 the host's speed hardly changes.
constexpr float kTriangleCost = 0.3F;

}  // namespace

Collapse::Collapse(const BinaryBvh& tree, int most_in_leaf) : tree_(tree) {
    choice_of_.resize(tree.size());
    std::uint32_t inner = 0;
    for (std::size_t i = 0; i < tree.size(); ++i)
        if (!tree[i].leaf()) choice_of_[i] = inner++;
    choices_.resize(inner);
    for (std::size_t i = tree.size(); i-- > 0;)
        if (!tree[i].leaf()) choose(static_cast<std::uint32_t>(i), most_in_leaf);
}

float Collapse::cost(std::uint32_t node, int roots) const {
    if (tree_[node].leaf()) return tree_[node].box.half_area_m2() * kTriangleCost;
    return choices_[choice_of_[node]].cost[roots - 1];
}

int Collapse::primitive_count(std::uint32_t node) const {
    return tree_[node].leaf() ? 1 : choices_[choice_of_[node]].primitives;
}

void Collapse::choose(std::uint32_t node, int most_in_leaf) {
    const std::uint32_t left = tree_[node].first_child;
    const std::uint32_t right = left + 1;
    Choice& c = choices_[choice_of_[node]];
    const auto cheapest = [&](int roots, std::uint8_t& on_the_left) {
        float best = std::numeric_limits<float>::infinity();
        on_the_left = 1;
        for (int k = std::max(1, roots - (kWidth - 1)); k < roots && k < kWidth; ++k) {
            const float both = cost(left, k) + cost(right, roots - k);
            if (both < best) {
                best = both;
                on_the_left = static_cast<std::uint8_t>(k);
            }
        }
        return best;
    };
    const int count = primitive_count(left) + primitive_count(right);
    c.primitives = static_cast<std::uint8_t>(std::min(count, 255));
    const float area_m2 = tree_[node].box.half_area_m2();
    c.cost[0] = cheapest(kWidth, c.left_of_children) + area_m2;
    c.left[0] = 0;
    const float as_leaf = area_m2 * kTriangleCost * static_cast<float>(count);
    c.leaf = count <= most_in_leaf && as_leaf <= c.cost[0];
    if (c.leaf) c.cost[0] = as_leaf;
    for (int roots = 2; roots < kWidth; ++roots) {
        std::uint8_t on_the_left = 0;
        const float split = cheapest(roots, on_the_left);
        const bool fewer = c.cost[roots - 2] <= split;
        c.cost[roots - 1] = fewer ? c.cost[roots - 2] : split;
        c.left[roots - 1] = fewer ? std::uint8_t{0} : on_the_left;
    }
}

void Collapse::add_roots(std::uint32_t node, int roots, std::vector<Child>& out) const {
    if (tree_[node].leaf()) return out.push_back({node, true});
    const Choice& c = choices_[choice_of_[node]];
    while (roots > 1 && c.left[roots - 1] == 0) --roots;
    if (roots == 1) return out.push_back({node, c.leaf});
    const int on_the_left = c.left[roots - 1];
    add_roots(tree_[node].first_child, on_the_left, out);
    add_roots(tree_[node].first_child + 1, roots - on_the_left, out);
}

std::vector<Collapse::Child> Collapse::children(std::uint32_t node) const {
    std::vector<Child> out;
    if (tree_[node].leaf()) return {{node, true}};
    const int on_the_left = choices_[choice_of_[node]].left_of_children;
    add_roots(tree_[node].first_child, on_the_left, out);
    add_roots(tree_[node].first_child + 1, kWidth - on_the_left, out);
    return out;
}

std::vector<std::uint32_t> Collapse::primitives(std::uint32_t node) const {
    std::vector<std::uint32_t> out;
    std::vector<std::uint32_t> open{node};
    while (!open.empty()) {
        const BinaryNode& n = tree_[open.back()];
        open.pop_back();
        if (n.leaf()) {
            out.push_back(n.primitive);
            continue;
        }
        open.push_back(n.first_child + 1);
        open.push_back(n.first_child);
    }
    return out;
}

}  // namespace foverig
