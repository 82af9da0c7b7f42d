#pragma once
// Whole queues on one thread of the host: the twin of cuda/cuda_backend.cuh, pass by pass, by which
// what runs on the GPU is tested where there is none.
#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

#include "renderer/backends/host_bvh/queues.h"
#include "renderer/buffer.h"
#include "renderer/pass_table.h"
#include "renderer/queue_size.h"

namespace foverig::host_bvh {

class HostBackend {
  public:
    template <class T>
    using Array = Buffer<T>;

    /// Borrows the scene.
    explicit HostBackend(const HostBvhScene& scene) : scene_(scene) {}

    const SceneView& view() const { return scene_.view(); }

    template <class T>
    void upload(Array<T>& to, View<const T> from) {
        std::copy(from.begin(), from.end(), to.data());
    }
    template <class T>
    std::vector<T> download(const Array<T>& from) const {
        return {from.view().begin(), from.view().end()};
    }

    /// kernel(i) for i in [0, size).
    template <class Kernel>
    void launch(const char* name, QueueSize size, const Kernel& kernel) {
        timed(name, [&] {
            for (int i = 0; i < size.get(); ++i) kernel(i);
            return std::uint64_t{0};
        });
    }

    /// Places of the elements that keep(i) keeps: on_place(i, place or -1). The size holds until
    /// the next call.
    template <class Keep, class OnPlace>
    QueueSize number(const char* name, int n, const Keep& keep, const OnPlace& on_place) {
        number_ = 0;
        timed(name, [&] {
            for (int i = 0; i < n; ++i) on_place(i, keep(i) ? number_++ : -1);
            return std::uint64_t{0};
        });
        return {n, &number_};
    }

    /// make_ray(i) -> Ray; on_hit(i, Hit).
    template <class MakeRay, class OnHit>
    void closest(const char* name, QueueSize size, const MakeRay& make_ray, const OnHit& on_hit) {
        timed(name, [&] {
            host_bvh::closest(scene_, size.get(), make_ray, on_hit);
            return static_cast<std::uint64_t>(size.get());
        });
    }

    /// make_ray(slot, sample) -> WeightedRay; on_sum(slot, sum of the weights of visible samples).
    template <class MakeRay, class OnSum>
    void visible(const char* name, QueueSize size, int samples, const MakeRay& make_ray,
                 const OnSum& on_sum) {
        timed(name,
              [&] { return host_bvh::visible(scene_, size.get(), samples, make_ray, on_sum); });
    }

    /// Times and rays of the passes since the last call.
    PassTable take_passes() { return std::exchange(passes_, {}); }

  private:
    /// `work` returns the rays it traced.
    template <class Work>
    void timed(const char* name, const Work& work) {
        const auto start = std::chrono::steady_clock::now();
        const std::uint64_t rays = work();
        passes_.add(name,
                    std::chrono::duration_cast<std::chrono::nanoseconds>(
                        std::chrono::steady_clock::now() - start)
                        .count(),
                    rays);
    }

    const HostBvhScene& scene_;
    int number_ = 0;
    PassTable passes_;
};

}  // namespace foverig::host_bvh
