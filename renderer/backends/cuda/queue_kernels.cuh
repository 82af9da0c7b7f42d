#pragma once
// What a launch runs on the device. Tracing kernels are persistent: as many threads as fit at once
// take warps of rays off a counter until the queue is empty (Aila and Laine 2009).
#include <type_traits>

#include "renderer/queue_size.h"
#include "renderer/trace/traverse.h"

namespace foverig::cuda {

inline constexpr int kThreads = 128;
inline constexpr int kWarp = 32;
/// Resident blocks that a tracing kernel's registers leave room for: 80 registers a thread. Left to
/// itself the assembler aims at more blocks and spills (tests/house/spills).
inline constexpr int kTracingBlocks = 6;
inline constexpr unsigned kAllLanes = 0xFFFFFFFFU;

/// A scene as tracing kernels take it: all pointers are the device's.
struct TracedView {
    BvhView bvh;
    SceneView scene;
};

/// Of one tracing pass; zeroed before the frame.
struct QueueCounter {
    unsigned next;              ///< first element that no warp has taken
    unsigned long long traced;  ///< rays that were not of weight 0
};

template <class Kernel>
__global__ void __launch_bounds__(kThreads) run(Kernel kernel, QueueSize size) {
    const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    if (i < size.get()) kernel(i);
}

/// First of the next 32 elements, the same in all lanes.
__device__ inline unsigned take_warp(QueueCounter* counter) {
    unsigned first = 0;
    if (threadIdx.x % kWarp == 0) first = atomicAdd(&counter->next, unsigned{kWarp});
    return __shfl_sync(kAllLanes, first, 0);
}

template <bool kAlpha, class MakeRay, class OnHit>
__global__ void __launch_bounds__(kThreads, kTracingBlocks)
    trace_closest(TracedView scene, QueueSize size, QueueCounter* counter, MakeRay make_ray,
                  OnHit on_hit) {
    const auto n = static_cast<unsigned>(size.get());
    for (unsigned first = take_warp(counter); first < n; first = take_warp(counter)) {
        const unsigned i = first + threadIdx.x % kWarp;
        if (i < n) {
            Hit hit =
                traverse<false, kAlpha>(scene.bvh, scene.scene, make_ray(static_cast<int>(i)));
            if (hit.missed()) hit = {};
            on_hit(static_cast<int>(i), hit);
        }
        __syncwarp();
    }
    if (blockIdx.x == 0 && threadIdx.x == 0) counter->traced = n;
}

/// What came of a slot's rays, by sample.
struct Shares {
    const float* of_first;  ///< of the slot's first sample
    std::size_t stride;

    __device__ float operator()(int sample) const {
        return of_first[static_cast<std::size_t>(sample) * stride];
    }
};

/// Ray k is sample k / n of slot k % n, so that the lanes of a warp have neighbouring surfaces and
/// one sample number. `shares`[k] becomes its weight if it is visible, else 0; without shares there
/// is one sample a slot, which goes straight to `on_shares`.
template <bool kAlpha, class MakeRay, class OnShares>
__global__ void __launch_bounds__(kThreads, kTracingBlocks)
    trace_visible(TracedView scene, QueueSize size, int samples, QueueCounter* counter,
                  float* shares, MakeRay make_ray, OnShares on_shares) {
    const auto n = static_cast<unsigned>(size.get());
    const unsigned rays = n * static_cast<unsigned>(samples);
    unsigned traced = 0;
    for (unsigned first = take_warp(counter); first < rays; first = take_warp(counter)) {
        const unsigned k = first + threadIdx.x % kWarp;
        bool asked = false;
        if (k < rays) {
            const int slot = static_cast<int>(k % n);
            const WeightedRay r = make_ray(slot, static_cast<int>(k / n));
            asked = r.weight > 0.0F;
            float share = 0.0F;
            if (asked && traverse<true, kAlpha>(scene.bvh, scene.scene, r.ray).missed())
                share = r.weight;
            if (shares != nullptr)
                shares[k] = share;
            else
                on_shares(slot, [share](int) { return share; });
        }
        traced += static_cast<unsigned>(__popc(__ballot_sync(kAllLanes, asked)));
    }
    if (threadIdx.x % kWarp == 0 && traced > 0)
        atomicAdd(&counter->traced, static_cast<unsigned long long>(traced));
}

template <class OnShares>
__global__ void __launch_bounds__(kThreads)
    give_shares(QueueSize size, const float* shares, OnShares on_shares) {
    const int n = size.get();
    const int slot = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    if (slot < n) on_shares(slot, Shares{shares + slot, static_cast<std::size_t>(n)});
}

}  // namespace foverig::cuda
