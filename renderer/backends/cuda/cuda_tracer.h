#pragma once
// Batches of rays on the GPU, for host code that knows nothing of CUDA.
#include <memory>
#include <vector>

#include "renderer/scene/scene_view.h"
#include "renderer/trace/packed_bvh.h"
#include "renderer/trace/ray.h"

namespace foverig::cuda {

class CudaBackend;

struct TracedHits {
    std::vector<Hit> hits;
    std::vector<double> ms;  ///< of each repetition, on the device's clock: tracing alone
};

struct TracedShadows {
    std::vector<float> visible;  ///< 1 where nothing is in the ray's way, else 0
    std::vector<double> ms;
};

class CudaTracer {
  public:
    /// Copies the scene; nothing is borrowed. `holes`: some triangle is alpha tested. Throws
    /// NoGpuError without a usable device, CudaError where a call fails; so do the calls below.
    CudaTracer(const SceneView& scene, const BvhView& bvh, bool holes);
    CudaTracer(const CudaTracer&) = delete;
    CudaTracer& operator=(const CudaTracer&) = delete;
    ~CudaTracer();

    /// The same rays in one launch, `repetitions` times.
    TracedHits closest(View<const Ray> rays, int repetitions = 1);
    TracedShadows visible(View<const Ray> rays, int repetitions = 1);

    std::uint64_t scene_bytes() const;

  private:
    std::unique_ptr<CudaBackend> backend_;
};

}  // namespace foverig::cuda
