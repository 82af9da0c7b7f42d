#pragma once
#include "renderer/trace/build/binary_bvh.h"
#include "renderer/trace/packed_bvh.h"

namespace foverig {

/// Which binary nodes become wide ones, at the least cost by the surface area heuristic (Ylitie
/// 2017): a dynamic program over all ways to cut a subtree into one
/// to seven roots.
class Collapse {
  public:
    /// `most_in_leaf` primitives at most share a leaf. Borrows the tree.
    Collapse(const BinaryBvh& tree, int most_in_leaf);

    struct Child {
        std::uint32_t node;
        bool leaf;  ///< its primitives go into one leaf
    };
    /// The one to eight children of the wide node that stands for `node`.
    std::vector<Child> children(std::uint32_t node) const;

    /// Primitives of a leaf child, in order.
    std::vector<std::uint32_t> primitives(std::uint32_t node) const;

  private:
    struct Choice {
        float cost[kWidth - 1];         ///< of the subtree as at most 1 .. 7 roots
        std::uint8_t left[kWidth - 1];  ///< roots on its left side; 0: one root fewer does it
        std::uint8_t left_of_children;  ///< the same where it becomes a wide node
        std::uint8_t primitives;        ///< saturates
        bool leaf;                      ///< as one root it is a leaf
    };
    float cost(std::uint32_t node, int roots) const;
    void choose(std::uint32_t node, int most_in_leaf);
    void add_roots(std::uint32_t node, int roots, std::vector<Child>& out) const;
    int primitive_count(std::uint32_t node) const;

    const BinaryBvh& tree_;
    std::vector<std::uint32_t> choice_of_;  ///< by node; leaves have none
    std::vector<Choice> choices_;
};

}  // namespace foverig
