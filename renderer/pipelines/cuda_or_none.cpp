#include "renderer/pipelines/cuda_or_none.h"

#include "renderer/backend_error.h"
#if defined(FOVERIG_HAS_CUDA)
#include "renderer/backends/cuda/cuda_error.h"
#include "renderer/backends/cuda/device_info.h"
#include "renderer/backends/embree/split_build.h"
#include "renderer/pipelines/cuda/cuda_renderer.h"
#endif

namespace foverig {

#if defined(FOVERIG_HAS_CUDA)

std::string why_no_gpu() {
    try {
        cuda::device_info();
        return {};
    } catch (const cuda::CudaError& error) {
        return error.what();
    }
}

std::unique_ptr<Renderer> make_gpu_renderer(std::shared_ptr<const Scene> scene,
                                            const RenderSettings& settings) {
    cuda::CudaSettings how;
    how.build_still = [threads = settings.threads](std::span<const Corners> triangles) {
        return embree::build_with_splits(triangles, threads);
    };
    return cuda::make_cuda_renderer(std::move(scene), settings, how);
}

#else

std::string why_no_gpu() {
    return "this program was built without CUDA; build it again where nvcc is";
}

std::unique_ptr<Renderer> make_gpu_renderer(std::shared_ptr<const Scene> /*scene*/,
                                            const RenderSettings& /*settings*/) {
    throw BackendError(why_no_gpu());
}

#endif

}  // namespace foverig
