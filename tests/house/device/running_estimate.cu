#include "renderer/kernels/running_estimate.h"

#include "tests/house/device/launch.h"

namespace foverig::device {

__global__ void weigh(SmallestWeight smallest, const CacheInfo* infos, float* weights,
                      std::uint32_t frame, int n) {
    if (index() >= n) return;
    const CacheInfo info = infos[index()];
    const float alpha = new_sample_weight(info_alpha(info), smallest(age_frames(info, frame)));
    weights[index()] = accumulated_samples(info_alpha(pack_info(alpha, frame)), alpha);
}

}  // namespace foverig::device
