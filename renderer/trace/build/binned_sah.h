#pragma once
#include "renderer/trace/build/binary_bvh.h"

namespace foverig {

/// Levels that are split where the surface area heuristic says, before halves are taken.
inline constexpr int kSahLevels = 64;

/// Top-down binned build by the surface area heuristic (Wald 2007), one primitive a leaf. No branch
/// is longer than sah_levels + log2(boxes) + 1. The same boxes give the same tree.
BinaryBvh build_binned(std::span<const Box> boxes, int sah_levels = kSahLevels);

/// The same as a BuildBinary: for machines and geometry that Embree's builder is not for.
BinaryBvh build_binned_triangles(std::span<const Corners> triangles);

}  // namespace foverig
