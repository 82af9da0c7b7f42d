#include "renderer/backends/embree/cpu_backend.h"

#include <tbb/info.h>

namespace foverig::embree {

CpuBackend::CpuBackend(const Scene& scene, const EmbreeSettings& settings)
    : threads_(settings.threads > 0 ? settings.threads : tbb::info::default_concurrency()),
      arena_(std::make_unique<tbb::task_arena>(threads_)),
      scene_(scene, settings) {
    for (int i = 0; i < threads_; ++i) lanes_.emplace_back(scene_);
}

PassTable CpuBackend::take_passes() {
    PassTable sum;
    for (Lane& lane : lanes_) {
        sum.merge(lane.passes());
        lane.passes().clear();
    }
    return sum;
}

}  // namespace foverig::embree
