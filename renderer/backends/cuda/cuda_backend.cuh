#pragma once
// The renderer on one GPU: the contract of host_bvh/host_backend.h, whole queues at a time. Nothing
// waits for the device but take_passes and downloads.
#include <array>
#include <map>

#include "renderer/backends/cuda/device_scene.cuh"
#include "renderer/backends/cuda/frame_graph.cuh"
#include "renderer/backends/cuda/gl_texture.h"
#include "renderer/backends/cuda/number_kernels.cuh"
#include "renderer/backends/cuda/pass_clock.cuh"
#include "renderer/backends/host_bvh/host_bvh_scene.h"
#include "renderer/half.h"
#include "renderer/kernels/frame_eyes.h"
#include "renderer/pass_table.h"

namespace foverig::cuda {

class CudaBackend {
  public:
    template <class T>
    using Array = DeviceArray<T>;

    static constexpr const char* kName = "cuda";

    /// Copies the scene to the current device. `holes`: some triangle is alpha tested. Throws
    /// NoGpuError without a usable device, CudaError where a call fails.
    CudaBackend(const SceneView& scene, const BvhView& bvh, bool holes);
    /// The same, of a scene that may move. `graphs`: frames whose passes are those of the frame
    /// before are sent as one graph.
    CudaBackend(const host_bvh::HostBvhScene& scene, int device, bool graphs);
    CudaBackend(const CudaBackend&) = delete;
    CudaBackend& operator=(const CudaBackend&) = delete;
    ~CudaBackend() = default;

    /// Makes its device the calling thread's; before anything else on a thread.
    void enter() const { check(cudaSetDevice(device_), "cudaSetDevice"); }

    /// What kernels see; its lights are on the device too.
    const SceneView& view() const { return scene_.view().scene; }
    std::uint64_t bytes() const { return memory_.bytes; }
    int graphs_made() const { return graph_.made(); }

    template <class T>
    void upload(Array<T>& to, View<const T> from) {
        to.upload(from, stream_.get());
    }
    template <class T>
    std::vector<T> download(const Array<T>& from) {
        return from.download(stream_.get());
    }
    template <class T>
    std::vector<T> download(View<const T> from) {
        std::vector<T> to(from.size);
        copy_to_host(to.data(), from);
        return to;
    }
    /// An eye's image in pinned memory, until the next call for that eye.
    View<const Half4> on_host(View<const Half4> image, int eye);

    /// See gl_texture.h.
    bool copy_to_texture(View<const Half4> image, int width_px, int height_px, int eye,
                         unsigned int gl_texture) {
        return textures_.at(static_cast<std::size_t>(eye))
            .copy(image, width_px, height_px, gl_texture, stream_.get());
    }

    /// Moves what moves to where it is at a time; the next frame sees it there.
    void set_time(host_bvh::HostBvhScene& scene, double time_s);

    /// All passes of a frame. `as_before`: they are those of the frame before, over arrays of the
    /// same size and place.
    template <class Passes>
    void frame(bool as_before, const Passes& passes) {
        numbers_used_ = 0;
        if (moved_) scene_.upload(stream_.get());
        if (!graphs_ || !as_before) {
            all_passes(passes);
            return;
        }
        graph_.begin(stream_.get());
        clock_.set_captured(true);
        try {
            all_passes(passes);
        } catch (...) {
            clock_.abandon();
            FrameGraph::abandon(stream_.get());
            throw;
        }
        clock_.set_captured(false);
        graph_.launch(stream_.get());
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
    /// the device, until the next frame.
    template <class Keep, class OnPlace>
    QueueSize number(const char* name, QueueSize size, const Keep& keep, const OnPlace& on_place) {
        int* const total = next_number();
        if (size.most == 0) return {};
        const int blocks = blocks_of(size.most);
        reserve(block_counts_, static_cast<std::size_t>(blocks));
        clock_.begin(name, -1, stream_.get());
        count_kept<<<blocks, kThreads, 0, stream_.get()>>>(keep, size, block_counts_.data());
        check(cudaGetLastError(), name);
        sums_before<<<1, kScanThreads, 0, stream_.get()>>>(block_counts_.data(), blocks, total);
        check(cudaGetLastError(), name);
        give_places<<<blocks, kThreads, 0, stream_.get()>>>(keep, on_place, size,
                                                            block_counts_.data());
        check(cudaGetLastError(), name);
        clock_.end(stream_.get());
        return {size.most, total};
    }
    /// What the frame's calls of number() came to, in their order; waits.
    std::vector<int> take_numbers();

    /// make_ray(i) -> Ray; on_hit(i, Hit).
    template <class MakeRay, class OnHit>
    void closest(const char* name, QueueSize size, const MakeRay& make_ray, const OnHit& on_hit) {
        if (holes_)
            closest_with<true>(name, size, make_ray, on_hit);
        else
            closest_with<false>(name, size, make_ray, on_hit);
    }

    /// make_ray(slot, sample) -> WeightedRay; on_shares(slot, shares), where shares(sample) is the
    /// weight of that ray if nothing is in its way, else 0.
    template <class MakeRay, class OnShares>
    void visible(const char* name, QueueSize size, int samples, const MakeRay& make_ray,
                 const OnShares& on_shares) {
        if (holes_)
            visible_with<true>(name, size, samples, make_ray, on_shares);
        else
            visible_with<false>(name, size, samples, make_ray, on_shares);
    }

    /// Waits for all work so far; times and rays of the passes since the last call.
    PassTable take_passes();

  private:
    static int blocks_of(int n) { return (n + kThreads - 1) / kThreads; }

    template <class Passes>
    void all_passes(const Passes& passes) {
        if (moved_) {
            clock_.begin("move_geometry", -1, stream_.get());
            scene_.refit(stream_.get());
            clock_.end(stream_.get());
        }
        passes();
    }
    template <class T>
    void copy_to_host(T* to, View<const T> from) {
        check(cudaMemcpyAsync(to, from.data, from.size * sizeof(T), cudaMemcpyDeviceToHost,
                              stream_.get()),
              "cudaMemcpyAsync to the host");
        check(cudaStreamSynchronize(stream_.get()), "cudaStreamSynchronize after a download");
    }

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

    template <bool kAlpha, class MakeRay, class OnShares>
    void visible_with(const char* name, QueueSize size, int samples, const MakeRay& make_ray,
                      const OnShares& on_shares) {
        static_assert(std::is_trivially_copyable_v<MakeRay> &&
                      std::is_trivially_copyable_v<OnShares>);
        if (size.most == 0 || samples == 0) return;
        const std::size_t rays =
            static_cast<std::size_t>(size.most) * static_cast<std::size_t>(samples);
        if (samples > 1) reserve(shares_, rays);
        const auto kernel = trace_visible<kAlpha, MakeRay, OnShares>;
        const int blocks = resident_blocks(reinterpret_cast<const void*>(kernel), rays);
        const int counter = next_counter();
        clock_.begin(name, counter, stream_.get());
        kernel<<<blocks, kThreads, 0, stream_.get()>>>(
            scene_.view(), size, samples, counters_.data() + counter,
            samples > 1 ? shares_.data() : nullptr, make_ray, on_shares);
        check(cudaGetLastError(), name);
        if (samples > 1) {
            give_shares<<<blocks_of(size.most), kThreads, 0, stream_.get()>>>(
                size, std::as_const(shares_).data(), on_shares);
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
    int* next_number();

    int device_ = 0;
    bool graphs_ = false;
    MemoryCount memory_;
    MemoryCount pinned_;  ///< on the host
    Stream stream_;
    int multiprocessors_ = 0;
    bool holes_;
    DeviceScene scene_;
    DeviceArray<QueueCounter> counters_;
    DeviceArray<int> numbers_;
    DeviceArray<int> block_counts_;
    DeviceArray<float> shares_;
    int counters_used_ = 0;
    std::size_t numbers_used_ = 0;
    bool moved_ = false;
    std::array<PinnedArray<Half4>, kMostEyes> images_;
    std::array<GlTexture, kMostEyes> textures_;
    FrameGraph graph_;
    std::map<const void*, int> blocks_per_multiprocessor_;
    PassClock clock_;
};

}  // namespace foverig::cuda
