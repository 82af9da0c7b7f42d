#pragma once
// The renderer on one GPU: the contract of host_bvh/host_backend.h, whole queues at a time. Nothing
// waits for the device but take_passes and downloads.
#include <map>

#include "renderer/backends/cuda/device_scene.cuh"
#include "renderer/backends/cuda/number_kernels.cuh"
#include "renderer/backends/cuda/pass_clock.cuh"
#include "renderer/pass_table.h"

namespace foverig::cuda {

class CudaBackend {
  public:
    template <class T>
    using Array = DeviceArray<T>;

    /// Copies the scene to the current device. `holes`: some triangle is alpha tested. Throws
    /// NoGpuError without a usable device, CudaError where a call fails.
    CudaBackend(const SceneView& scene, const BvhView& bvh, bool holes);

    /// What kernels see; its lights are on the device too.
    const SceneView& view() const { return scene_.view().scene; }
    std::uint64_t bytes() const { return memory_.bytes; }

    template <class T>
    void upload(Array<T>& to, View<const T> from) {
        to.upload(from, stream_.get());
    }
    template <class T>
    std::vector<T> download(const Array<T>& from) {
        return from.download(stream_.get());
    }

    /// kernel(i) for i in [0, size).
    template <class Kernel>
    void launch(const char* name, QueueSize size, const Kernel& kernel) {
        static_assert(std::is_trivially_copyable_v<Kernel>);
        if (size.most == 0) return;
        clock_.begin(name, -1, stream_.get());
        run<<<blocks_of(size.most), kThreads, 0, stream_.get()>>>(kernel, size);
        check(cudaGetLastError(), name);
        clock_.end(stream_.get());
    }

    /// Places of the elements that keep(i) keeps: on_place(i, place or -1). Their number stays on
    /// the device, until the next call.
    template <class Keep, class OnPlace>
    QueueSize number(const char* name, int n, const Keep& keep, const OnPlace& on_place) {
        if (n == 0) return {};
        const int blocks = blocks_of(n);
        reserve(block_counts_, static_cast<std::size_t>(blocks));
        clock_.begin(name, -1, stream_.get());
        count_kept<<<blocks, kThreads, 0, stream_.get()>>>(keep, n, block_counts_.data());
        check(cudaGetLastError(), name);
        sums_before<<<1, kScanThreads, 0, stream_.get()>>>(block_counts_.data(), blocks,
                                                           number_.data());
        check(cudaGetLastError(), name);
        give_places<<<blocks, kThreads, 0, stream_.get()>>>(keep, on_place, n,
                                                            block_counts_.data());
        check(cudaGetLastError(), name);
        clock_.end(stream_.get());
        return {n, number_.data()};
    }

    /// make_ray(i) -> Ray; on_hit(i, Hit).
    template <class MakeRay, class OnHit>
    void closest(const char* name, QueueSize size, const MakeRay& make_ray, const OnHit& on_hit) {
        if (holes_)
            closest_with<true>(name, size, make_ray, on_hit);
        else
            closest_with<false>(name, size, make_ray, on_hit);
    }

    /// make_ray(slot, sample) -> WeightedRay; on_sum(slot, sum of the weights of visible samples).
    template <class MakeRay, class OnSum>
    void visible(const char* name, QueueSize size, int samples, const MakeRay& make_ray,
                 const OnSum& on_sum) {
        if (holes_)
            visible_with<true>(name, size, samples, make_ray, on_sum);
        else
            visible_with<false>(name, size, samples, make_ray, on_sum);
    }

    /// Waits for all work so far; times and rays of the passes since the last call.
    PassTable take_passes();

  private:
    static int blocks_of(int n) { return (n + kThreads - 1) / kThreads; }

    template <bool kAlpha, class MakeRay, class OnHit>
    void closest_with(const char* name, QueueSize size, const MakeRay& make_ray,
                      const OnHit& on_hit) {
        static_assert(std::is_trivially_copyable_v<MakeRay> && std::is_trivially_copyable_v<OnHit>);
        if (size.most == 0) return;
        const auto kernel = trace_closest<kAlpha, MakeRay, OnHit>;
        const int blocks = resident_blocks(reinterpret_cast<const void*>(kernel), size.most);
        const int counter = next_counter();
        clock_.begin(name, counter, stream_.get());
        kernel<<<blocks, kThreads, 0, stream_.get()>>>(
            scene_.view(), size, counters_.data() + counter, make_ray, on_hit);
        check(cudaGetLastError(), name);
        clock_.end(stream_.get());
    }

    template <bool kAlpha, class MakeRay, class OnSum>
    void visible_with(const char* name, QueueSize size, int samples, const MakeRay& make_ray,
                      const OnSum& on_sum) {
        static_assert(std::is_trivially_copyable_v<MakeRay> && std::is_trivially_copyable_v<OnSum>);
        if (size.most == 0 || samples == 0) return;
        const std::size_t rays =
            static_cast<std::size_t>(size.most) * static_cast<std::size_t>(samples);
        if (samples > 1) reserve(shares_, rays);
        const auto kernel = trace_visible<kAlpha, MakeRay, OnSum>;
        const int blocks = resident_blocks(reinterpret_cast<const void*>(kernel), rays);
        const int counter = next_counter();
        clock_.begin(name, counter, stream_.get());
        kernel<<<blocks, kThreads, 0, stream_.get()>>>(
            scene_.view(), size, samples, counters_.data() + counter,
            samples > 1 ? shares_.data() : nullptr, make_ray, on_sum);
        check(cudaGetLastError(), name);
        if (samples > 1) {
            sum_shares<<<blocks_of(size.most), kThreads, 0, stream_.get()>>>(
                size, samples, std::as_const(shares_).data(), on_sum);
            check(cudaGetLastError(), name);
        }
        clock_.end(stream_.get());
    }

    /// Grows, never shrinks: nothing is allocated once a frame of that size has been made.
    template <class T>
    void reserve(DeviceArray<T>& array, std::size_t size) {
        if (array.size() >= size) return;
        array = {};
        array = DeviceArray<T>(memory_, size);
    }

    /// Blocks that the device holds at once, or fewer where the queue is shorter. Throws for a
    /// queue of more rays than a counter can count past.
    int resident_blocks(const void* kernel, std::size_t rays);
    int next_counter();

    MemoryCount memory_;
    Stream stream_;
    int multiprocessors_ = 0;
    bool holes_;
    DeviceScene scene_;
    DeviceArray<QueueCounter> counters_;
    DeviceArray<int> number_;
    DeviceArray<int> block_counts_;
    DeviceArray<float> shares_;
    int counters_used_ = 0;
    std::map<const void*, int> blocks_per_multiprocessor_;
    PassClock clock_;
};

}  // namespace foverig::cuda
