#pragma once
// Pipelines on the GPU, for host code that knows nothing of CUDA.
#include <memory>

#include "renderer/renderer.h"
#include "renderer/trace/build/binary_bvh.h"

namespace foverig::cuda {

struct CudaSettings {
    int gpus = 0;             ///< eyes go to as many; 0: all of this machine, at most one an eye
    bool graphs = true;       ///< one CUDA graph a frame, from a pipeline's third frame on
    BuildBinary build_still;  ///< of what never moves; empty: the plain builder
};

/// Pipelines `full` and `reprojected`. Throws NoGpuError without a usable GPU, CudaError where a
/// call fails (so does the renderer), std::invalid_argument for another pipeline.
std::unique_ptr<Renderer> make_cuda_renderer(std::shared_ptr<const Scene> scene,
                                             const RenderSettings& settings,
                                             const CudaSettings& cuda_settings);

}  // namespace foverig::cuda
