#include "renderer/pipelines/cuda/cuda_full.h"

#include "renderer/backends/cuda/cuda_backend.cuh"
#include "renderer/pipelines/full_frame.h"

namespace foverig::cuda {

struct CudaFull::Parts {
    Parts(const Scene& scene, const SceneView& view, const BvhView& bvh, bool holes,
          const RenderSettings& settings)
        : backend(view, bvh, holes), frame(backend, scene, settings) {}

    CudaBackend backend;
    FullFrame<CudaBackend> frame;
};

CudaFull::CudaFull(const Scene& scene, const SceneView& view, const BvhView& bvh, bool holes,
                   const RenderSettings& settings)
    : parts_(std::make_unique<Parts>(scene, view, bvh, holes, settings)) {}

CudaFull::~CudaFull() = default;

PassTable CudaFull::render(const EyeView& eye, std::uint32_t frame) {
    parts_->frame.render(eye, frame);
    return parts_->backend.take_passes();
}

std::vector<Half4> CudaFull::image() const {
    return parts_->frame.image();
}

NumericCounts CudaFull::numerics() const {
    return parts_->frame.numerics();
}

}  // namespace foverig::cuda
