#include "renderer/kernels/running_estimate.h"

#include "tests/house/device/launch.h"

namespace foverig::device {

__global__ void weigh(SmallestWeight smallest, const CacheInfo* infos, float* weights,
                      std::uint32_t frame, int n) {
    if (index() >= n) return;
    const float rho = weights[index()];
    const float alpha = new_sample_weight(rho, smallest(age_frames(infos[index()], frame)));
    weights[index()] = accumulated_samples(rho, alpha);
}

}  // namespace foverig::device
