#include "bench/gpu/device_binary.h"

#include <algorithm>

#include "bench/gpu/event_times.cuh"
#include "renderer/backends/cuda/device_scene.cuh"

namespace foverig::gpu {
namespace {

using cuda::check;
using cuda::DeviceArray;
using cuda::kThreads;
using cuda::kTracingBlocks;
using cuda::kWarp;
using cuda::QueueCounter;

template <bool kAlpha>
__global__ void __launch_bounds__(kThreads, kTracingBlocks)
    trace_closest_binary(BinaryView bvh, SceneView scene, View<const Ray> rays,
                         QueueCounter* counter, View<Hit> hits) {
    const auto n = static_cast<unsigned>(rays.size);
    for (unsigned first = cuda::take_warp(counter); first < n; first = cuda::take_warp(counter)) {
        const unsigned i = first + threadIdx.x % kWarp;
        if (i < n) {
            Hit hit = traverse_binary<false, kAlpha>(bvh, scene, rays[i]);
            if (hit.missed()) hit = {};
            hits[i] = hit;
        }
        __syncwarp();
    }
}

int resident_blocks(const void* kernel, std::size_t rays) {
    int device = 0;
    int multiprocessors = 0;
    int blocks = 0;
    check(cudaGetDevice(&device), "cudaGetDevice");
    check(cudaDeviceGetAttribute(&multiprocessors, cudaDevAttrMultiProcessorCount, device),
          "cudaDeviceGetAttribute");
    check(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&blocks, kernel, kThreads, 0),
          "cudaOccupancyMaxActiveBlocksPerMultiprocessor");
    const auto full = static_cast<std::size_t>(std::max(blocks, 1) * multiprocessors);
    return static_cast<int>(std::min(full, (rays + kThreads - 1) / kThreads));
}

}  // namespace

cuda::TracedHits closest_by_binary(const SceneView& scene, const BinaryView& bvh, bool holes,
                                   View<const Ray> rays, int repetitions) {
    const cuda::Stream owned = cuda::make_stream();
    cudaStream_t const stream = owned.get();
    MemoryCount count;
    const cuda::DeviceScene on_device(count, scene, {}, stream);
    const auto copy = [&]<class T>(View<const T> from) {
        DeviceArray<T> array(count, from.size);
        if (!from.empty()) array.upload(from, stream);
        return array;
    };
    const DeviceArray<PairNode> nodes = copy(bvh.nodes);
    const DeviceArray<PackedTriangle> triangles = copy(bvh.triangles);
    const DeviceArray<Ray> device_rays = copy(rays);
    DeviceArray<Hit> hits(count, rays.size);
    DeviceArray<QueueCounter> counter(count, 1);
    const BinaryView view{bvh.root, nodes.view(), triangles.view(), bvh.bounds};
    const auto kernel = holes ? trace_closest_binary<true> : trace_closest_binary<false>;
    const int blocks = resident_blocks(reinterpret_cast<const void*>(kernel), rays.size);
    std::vector<double> ms = event_times_ms(stream, repetitions, [&] {
        check(cudaMemsetAsync(counter.data(), 0, sizeof(QueueCounter), stream), "cudaMemsetAsync");
        kernel<<<blocks, kThreads, 0, stream>>>(view, on_device.view().scene, device_rays.view(),
                                                counter.data(), hits.view());
        check(cudaGetLastError(), "trace_closest_binary");
    });
    return {hits.download(stream), std::move(ms)};
}

}  // namespace foverig::gpu
