#pragma once
// How the device would run each kind of kernel. Compiling an instantiation proves that nothing in
// the kernel is host-only; nothing here is ever run.
#include <cstdint>
#include <type_traits>

#include "renderer/trace/ray.h"

namespace foverig::device {

__device__ inline int index() {
    return static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
}

/// kernel(i) for i in [0, n).
template <class Kernel>
__global__ void launch(Kernel kernel, int n) {
    static_assert(std::is_trivially_copyable_v<Kernel>, "a kernel travels to the device as bytes");
    if (index() < n) kernel(index());
}

/// What a tracer's pass does around its tracing: makes a ray, hands a hit on.
template <class MakeRay, class OnHit>
__global__ void closest(MakeRay make_ray, OnHit on_hit, Ray* rays, const Hit* hits, int n) {
    static_assert(std::is_trivially_copyable_v<MakeRay> && std::is_trivially_copyable_v<OnHit>);
    if (index() >= n) return;
    rays[index()] = make_ray(index());
    on_hit(index(), hits[index()]);
}

template <class MakeRay, class OnSum>
__global__ void visible(MakeRay make_ray, OnSum on_sum, WeightedRay* rays, const float* sums, int n,
                        int samples) {
    static_assert(std::is_trivially_copyable_v<MakeRay> && std::is_trivially_copyable_v<OnSum>);
    if (index() >= n) return;
    for (int sample = 0; sample < samples; ++sample)
        rays[index() * samples + sample] = make_ray(index(), sample);
    on_sum(index(), sums[index()]);
}

}  // namespace foverig::device

#define FOVERIG_LAUNCH(...) template __global__ void foverig::device::launch(__VA_ARGS__, int)
#define FOVERIG_CLOSEST(rays, sink)                                              \
    template __global__ void foverig::device::closest(rays, sink, foverig::Ray*, \
                                                      const foverig::Hit*, int)
#define FOVERIG_VISIBLE(rays, sink)                                                      \
    template __global__ void foverig::device::visible(rays, sink, foverig::WeightedRay*, \
                                                      const float*, int, int)
