#include "renderer/kernels/secondary_rays.h"

#include "tests/house/device/launch.h"

namespace foverig::device {

template <class MakeRay, class OnShares>
__global__ void shares(MakeRay make_ray, OnShares on_shares, WeightedRay* rays, const float* sums,
                       int n) {
    if (index() >= n) return;
    rays[index()] = make_ray(index(), 1);
    on_shares(index(), [sums](int sample) { return sums[sample]; });
}

template __global__ void shares(SecondaryRays<false, false>, AddSecondary<false, false>,
                                WeightedRay*, const float*, int);
template __global__ void shares(SecondaryRays<true, true>, AddSecondary<true, true>, WeightedRay*,
                                const float*, int);

}  // namespace foverig::device
