#include "renderer/pipelines/cuda/cuda_renderer.h"

#include <algorithm>

#include "renderer/backends/cuda/cuda_backend.cuh"
#include "renderer/backends/cuda/device_info.h"
#include "renderer/pipelines/frame/eyes_apart.h"
#include "renderer/pipelines/frame/frame_renderer.h"

namespace foverig::cuda {
namespace {

std::unique_ptr<Renderer> on_gpu(const std::shared_ptr<const Scene>& scene,
                                 const RenderSettings& settings, const CudaSettings& how,
                                 int device) {
    if (settings.pipeline == "full")
        return std::make_unique<FrameRenderer<CudaBackend, FullFrame>>(
            scene, settings, how.build_still, device, how.graphs);
    if (settings.pipeline == "reprojected")
        return std::make_unique<FrameRenderer<CudaBackend, ReprojectedFrame>>(
            scene, settings, how.build_still, device, how.graphs);
    throw std::invalid_argument("pipeline " + settings.pipeline +
                                " does not run on the GPU; choose full or reprojected, or another "
                                "backend");
}

}  // namespace

std::unique_ptr<Renderer> make_cuda_renderer(std::shared_ptr<const Scene> scene,
                                             const RenderSettings& settings,
                                             const CudaSettings& cuda_settings) {
    const int there = std::min(device_count(), kMostEyes);
    const int gpus = cuda_settings.gpus > 0 ? cuda_settings.gpus : std::max(1, there);
    if (gpus == 1) return on_gpu(scene, settings, cuda_settings, 0);
    std::vector<std::unique_ptr<Renderer>> parts;
    for (int device = 0; device < std::min(gpus, kMostEyes); ++device)
        parts.push_back(on_gpu(scene, settings, cuda_settings, device));
    return std::make_unique<EyesApart>(std::move(parts));
}

}  // namespace foverig::cuda
