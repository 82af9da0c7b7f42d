#pragma once
// Whole queues on one thread of the host: the twin of cuda/cuda_backend.cuh, pass by pass, by which
// what runs on the GPU is tested where there is none.
#include <algorithm>
#include <array>
#include <chrono>
#include <utility>
#include <vector>

#include "renderer/backends/host_bvh/queues.h"
#include "renderer/buffer.h"
#include "renderer/half.h"
#include "renderer/pass_table.h"
#include "renderer/queue_size.h"

namespace foverig::host_bvh {

class HostBackend {
  public:
    template <class T>
    using Array = Buffer<T>;

    static constexpr const char* kName = "host-bvh";

    /// Borrows the scene.
    explicit HostBackend(const HostBvhScene& scene) : scene_(scene) {}

    /// For backends that have a device to choose.
    void enter() const {}

    const SceneView& view() const { return scene_.view(); }

    template <class T>
    void upload(Array<T>& to, View<const T> from) {
        std::copy(from.begin(), from.end(), to.data());
    }
    template <class T>
    std::vector<T> download(View<const T> from) const {
        return {from.begin(), from.end()};
    }
    template <class T>
    std::vector<T> download(const Array<T>& from) const {
        return download(from.view());
    }

    /// An eye's image where the host can read it, until the next frame.
    View<const Half4> on_host(View<const Half4> image, int /*eye*/) const { return image; }

    bool copy_to_texture(View<const Half4> /*image*/, int /*width_px*/, int /*height_px*/,
                         int /*eye*/, unsigned int /*gl_texture*/) {
        return false;
    }

    /// Moves what moves, in the scene that it borrows, to where it is at a time.
    void set_time(HostBvhScene& scene, double time_s) {
        timed("move_geometry", [&] {
            scene.set_time(time_s);
            return std::uint64_t{0};
        });
    }
    /// Memory of its own besides the scene and arrays.
    std::uint64_t bytes() const { return 0; }

    /// All passes of a frame. `as_before`: they are those of the frame before, over arrays of the
    /// same size and place.
    template <class Passes>
    void frame(bool /*as_before*/, const Passes& passes) {
        numbers_used_ = 0;
        passes();
    }

    /// kernel(i) for i in [0, size).
    template <class Kernel>
    void launch(const char* name, QueueSize size, const Kernel& kernel) {
        timed(name, [&] {
            for (int i = 0; i < size.get(); ++i) kernel(i);
            return std::uint64_t{0};
        });
    }

    /// Places of the elements that keep(i) keeps: on_place(i, place or -1). Their number holds
    /// until the next frame.
    template <class Keep, class OnPlace>
    QueueSize number(const char* name, QueueSize size, const Keep& keep, const OnPlace& on_place) {
        int& number = numbers_.at(numbers_used_++);
        number = 0;
        timed(name, [&] {
            for (int i = 0; i < size.get(); ++i) on_place(i, keep(i) ? number++ : -1);
            return std::uint64_t{0};
        });
        return {size.most, &number};
    }
    /// What the frame's calls of number() came to, in their order.
    std::vector<int> take_numbers() {
        return {numbers_.begin(), numbers_.begin() + static_cast<std::ptrdiff_t>(numbers_used_)};
    }

    /// make_ray(i) -> Ray; on_hit(i, Hit).
    template <class MakeRay, class OnHit>
    void closest(const char* name, QueueSize size, const MakeRay& make_ray, const OnHit& on_hit) {
        timed(name, [&] {
            host_bvh::closest(scene_, size.get(), make_ray, on_hit);
            return static_cast<std::uint64_t>(size.get());
        });
    }

    /// make_ray(slot, sample) -> WeightedRay; on_shares(slot, shares), where shares(sample) is the
    /// weight of that ray if nothing is in its way, else 0.
    template <class MakeRay, class OnShares>
    void visible(const char* name, QueueSize size, int samples, const MakeRay& make_ray,
                 const OnShares& on_shares) {
        timed(name, [&] {
            shares_.resize(static_cast<std::size_t>(samples));
            std::uint64_t traced = 0;
            for (int slot = 0; slot < size.get(); ++slot) {
                for (int sample = 0; sample < samples; ++sample) {
                    const WeightedRay r = make_ray(slot, sample);
                    const bool asked = r.weight > 0.0F;
                    traced += asked ? 1U : 0U;
                    shares_[static_cast<std::size_t>(sample)] =
                        asked && !scene_.occluded(r.ray) ? r.weight : 0.0F;
                }
                on_shares(slot,
                          [&](int sample) { return shares_[static_cast<std::size_t>(sample)]; });
            }
            return traced;
        });
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
    std::array<int, kMostNumbers> numbers_{};
    std::size_t numbers_used_ = 0;
    std::vector<float> shares_;  ///< of one slot
    PassTable passes_;
};

}  // namespace foverig::host_bvh
