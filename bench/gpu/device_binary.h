#pragma once
#include "bench/gpu/binary_traverse.h"
#include "renderer/backends/cuda/cuda_tracer.h"

namespace foverig::gpu {

/// The same rays by the binary BVH, launched as CudaTracer::closest launches the wide one:
/// persistent warps off a counter, as many blocks. Throws CudaError where a call fails.
cuda::TracedHits closest_by_binary(const SceneView& scene, const BinaryView& bvh, bool holes,
                                   View<const Ray> rays, int repetitions);

}  // namespace foverig::gpu
