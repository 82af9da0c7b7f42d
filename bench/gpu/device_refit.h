#pragma once
#include <memory>
#include <vector>

#include "renderer/scene/scene_view.h"
#include "renderer/trace/build/refit_plan.h"

namespace foverig::gpu {

/// A scene on the GPU whose parts move, for host code that knows nothing of CUDA. Throws CudaError
/// where a call fails.
class DeviceRefit {
  public:
    DeviceRefit(const SceneView& scene, const BvhView& bvh, const RefitPlan& plan);
    DeviceRefit(const DeviceRefit&) = delete;
    DeviceRefit& operator=(const DeviceRefit&) = delete;
    ~DeviceRefit();

    void move(const SceneView& posed);           ///< launch by launch
    void move_by_graph(const SceneView& posed);  ///< the same as one graph, captured at first use

    std::vector<WideNode> nodes() const;
    std::vector<PackedTriangle> packed_triangles() const;

    struct Times {
        std::vector<double> upload_ms;
        std::vector<double> refit_ms;
        std::vector<double> graph_ms;  ///< both, as one graph
    };
    /// Of what was staged last, on the device's clock.
    Times times(int repetitions);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace foverig::gpu
