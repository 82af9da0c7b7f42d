#pragma once
// The `full` pipeline on the GPU, one eye, for host code that knows nothing of CUDA.
#include <memory>
#include <vector>

#include "renderer/camera.h"
#include "renderer/counts.h"
#include "renderer/half.h"
#include "renderer/pass_table.h"
#include "renderer/scene/scene_view.h"
#include "renderer/settings.h"
#include "renderer/trace/packed_bvh.h"

namespace foverig::cuda {

class CudaFull {
  public:
    /// Copies what `view` and `bvh` hold of `scene`, and borrows `scene`. Throws NoGpuError without
    /// a usable device, CudaError where a call fails; so do the calls below.
    CudaFull(const Scene& scene, const SceneView& view, const BvhView& bvh, bool holes,
             const RenderSettings& settings);
    CudaFull(const CudaFull&) = delete;
    CudaFull& operator=(const CudaFull&) = delete;
    ~CudaFull();

    /// Renders and waits. Times by pass on the device's clock, and rays.
    PassTable render(const EyeView& eye, std::uint32_t frame);

    /// Of the last frame: linear RGB row by row from the top; w is 0.
    std::vector<Half4> image() const;
    NumericCounts numerics() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace foverig::cuda
