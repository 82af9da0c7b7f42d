#pragma once
#include "renderer/trace/build/binary_bvh.h"

namespace foverig::embree {

/// Embree's builder at its highest quality: surface area heuristic with spatial splits (Stich,
/// Friedrich and Dietrich 2009), one triangle a leaf. `threads` 0: one a core. The tree may differ
/// with the number of threads; what rays hit does not.
BinaryBvh build_with_splits(std::span<const Corners> triangles, int threads);

}  // namespace foverig::embree
