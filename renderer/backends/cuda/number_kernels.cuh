#pragma once
// Numbers the elements of a queue that are kept, in order: counts a block, sums over blocks,
// places. Deterministic, unlike places taken off a counter.
#include "renderer/backends/cuda/queue_kernels.cuh"

namespace foverig::cuda {

inline constexpr int kScanThreads = 1024;

template <class Keep>
__global__ void __launch_bounds__(kThreads) count_kept(Keep keep, QueueSize size, int* counts) {
    const int n = size.get();
    const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    const int kept = __syncthreads_count(i < n && keep(i) ? 1 : 0);
    if (threadIdx.x == 0) counts[blockIdx.x] = kept;
}

/// One block: each count becomes the sum of those before it; *total the sum of all.
static __global__ void __launch_bounds__(kScanThreads)
    sums_before(int* counts, int blocks, int* total) {
    __shared__ int sums[kScanThreads];
    const int thread = static_cast<int>(threadIdx.x);
    const int each = (blocks + kScanThreads - 1) / kScanThreads;
    const int begin = thread * each;
    const int end = begin + each < blocks ? begin + each : blocks;
    int own = 0;
    for (int i = begin; i < end; ++i) own += counts[i];
    sums[thread] = own;
    __syncthreads();
    for (int step = 1; step < kScanThreads; step *= 2) {
        const int before = thread >= step ? sums[thread - step] : 0;
        __syncthreads();
        sums[thread] += before;
        __syncthreads();
    }
    int sum = sums[thread] - own;
    for (int i = begin; i < end; ++i) {
        const int count = counts[i];
        counts[i] = sum;
        sum += count;
    }
    if (thread == kScanThreads - 1) *total = sums[thread];
}

/// on_place(i, place of the i-th element among the kept ones, or -1).
template <class Keep, class OnPlace>
__global__ void __launch_bounds__(kThreads)
    give_places(Keep keep, OnPlace on_place, QueueSize size, const int* before_block) {
    const int n = size.get();
    __shared__ int warps[kThreads / kWarp];
    const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    const bool kept = i < n && keep(i);
    const unsigned votes = __ballot_sync(kAllLanes, kept);
    const unsigned lane = threadIdx.x % kWarp;
    const unsigned warp = threadIdx.x / kWarp;
    if (lane == 0) warps[warp] = __popc(votes);
    __syncthreads();
    int place = before_block[blockIdx.x] + __popc(votes & ((1U << lane) - 1U));
    for (unsigned w = 0; w < warp; ++w) place += warps[w];
    if (i < n) on_place(i, kept ? place : -1);
}

}  // namespace foverig::cuda
