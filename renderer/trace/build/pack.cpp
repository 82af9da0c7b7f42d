#include "renderer/trace/build/pack.h"

#include <limits>

#include "renderer/trace/build/collapse.h"
#include "renderer/trace/quantise.h"

namespace foverig {
namespace {

using Slots = std::array<int, kWidth>;  ///< child of each slot, or -1

/// Greedy: the child and slot that agree most come first.
Slots give_slots(const BinaryBvh& tree, const Box& box,
                 const std::vector<Collapse::Child>& children) {
    Slots slots;
    slots.fill(-1);
    std::array<bool, kWidth> placed{};
    const vec3 middle = box.middle_m();
    for (std::size_t round = 0; round < children.size(); ++round) {
        float best = -std::numeric_limits<float>::infinity();
        std::size_t best_child = 0;
        std::size_t best_slot = 0;
        bool found = false;
        for (std::size_t c = 0; c < children.size(); ++c) {
            if (placed[c]) continue;
            const vec3 away = tree[children[c].node].box.middle_m() - middle;
            for (std::size_t s = 0; s < kWidth; ++s) {
                if (slots[s] >= 0) continue;
                const float agreement = ((s & 4U) != 0U ? away.x : -away.x) +
                                        ((s & 2U) != 0U ? away.y : -away.y) +
                                        ((s & 1U) != 0U ? away.z : -away.z);
                if (found && !(agreement > best)) continue;
                found = true;
                best = agreement;
                best_child = c;
                best_slot = s;
            }
        }
        placed[best_child] = true;
        slots[best_slot] = static_cast<int>(best_child);
    }
    return slots;
}

/// Nodes in the order in which they are met are the queue itself.
class Packer {
  public:
    Packer(const BinaryBvh& tree, Primitives become)
        : tree_(tree),
          become_(become),
          collapse_(tree, become == Primitives::triangles ? kLeafTriangles : 1) {}

    WideTree run() {
        if (tree_.empty()) return {};
        add_node(0, kNoPrimitive);
        for (std::size_t at = 0; at < out_.nodes.size();) {
            const std::size_t level_end = out_.nodes.size();
            out_.level_ends.push_back(static_cast<std::uint32_t>(level_end));
            for (; at < level_end; ++at)
                if (become_ == Primitives::triangles || out_.primitives[at] == kNoPrimitive)
                    fill(at);
        }
        return std::move(out_);
    }

  private:
    void add_node(std::uint32_t binary, std::uint32_t primitive) {
        binary_of_.push_back(binary);
        out_.nodes.emplace_back();
        if (become_ == Primitives::nodes) out_.primitives.push_back(primitive);
    }

    void fill(std::size_t at) {
        const std::uint32_t binary = binary_of_[at];
        const std::vector<Collapse::Child> children = collapse_.children(binary);
        const Slots slots = give_slots(tree_, tree_[binary].box, children);
        WideNode node{};
        node.first_child = static_cast<std::uint32_t>(out_.nodes.size());
        node.first_triangle = static_cast<std::uint32_t>(out_.primitives.size());
        Box boxes[kWidth];
        for (std::size_t slot = 0; slot < kWidth; ++slot) {
            if (slots[slot] < 0) continue;
            const Collapse::Child child = children[static_cast<std::size_t>(slots[slot])];
            boxes[slot] = tree_[child.node].box;
            if (child.leaf && become_ == Primitives::triangles) {
                add_leaf(node, slot, child.node);
                continue;
            }
            node.inner = static_cast<std::uint8_t>(node.inner | 1U << slot);
            node.meta[slot] = static_cast<std::uint8_t>(32U + 24U + slot);
            add_node(child.node, child.leaf ? tree_[child.node].primitive : kNoPrimitive);
        }
        set_boxes(node, boxes);
        out_.nodes[at] = node;
    }

    void add_leaf(WideNode& node, std::size_t slot, std::uint32_t binary) {
        const std::size_t first = out_.primitives.size() - node.first_triangle;
        const std::vector<std::uint32_t> held = collapse_.primitives(binary);
        out_.primitives.insert(out_.primitives.end(), held.begin(), held.end());
        const std::size_t unary = (1U << held.size()) - 1U;
        node.meta[slot] = static_cast<std::uint8_t>(unary << 5U | first);
    }

    const BinaryBvh& tree_;
    Primitives become_;
    Collapse collapse_;
    WideTree out_;
    std::vector<std::uint32_t> binary_of_;  ///< by wide node
};

}  // namespace

WideTree pack(const BinaryBvh& tree, Primitives become) {
    return Packer(tree, become).run();
}

}  // namespace foverig
