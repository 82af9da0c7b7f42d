#pragma once
// The renderer on the CPU: Embree or our own BVH traces, TBB spreads tiles over threads. A `Lane`
// runs the passes of one tile on one thread; the same pass code would run them over a whole frame
// on a GPU.
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "renderer/backends/embree/embree_scene.h"
#include "renderer/backends/embree/packets.h"
#include "renderer/backends/host_bvh/queues.h"
#include "renderer/pass_table.h"
#include "renderer/task_order.h"

namespace foverig {

/// What holds the scene and finds hits in it.
enum class Tracer { embree, host_bvh };

using TracedScene = std::variant<embree::EmbreeScene, host_bvh::HostBvhScene>;

/// Runs named passes one after the other and keeps their time.
class Lane {
  public:
    explicit Lane(const TracedScene& scene) : scene_(scene) {}

    /// kernel(i) for i in [0, n).
    template <class Kernel>
    void launch(const char* name, int n, const Kernel& kernel) {
        const auto start = now_ns();
        for (int i = 0; i < n; ++i) kernel(i);
        passes_.add(name, now_ns() - start);
    }

    template <class MakeRay, class OnHit>
    void closest(const char* name, int n, const MakeRay& make_ray, const OnHit& on_hit) {
        const auto start = now_ns();
        if (const auto* embree = std::get_if<embree::EmbreeScene>(&scene_))
            embree::closest(embree->handle(), embree->first_triangles(), n, make_ray, on_hit);
        else
            host_bvh::closest(std::get<host_bvh::HostBvhScene>(scene_), n, make_ray, on_hit);
        passes_.add(name, now_ns() - start, static_cast<std::uint64_t>(n));
    }

    /// `per_packet` samples of one slot share a packet, where packets are traced (see packets.h).
    /// Returns the number of rays traced.
    template <class MakeRay, class OnSum>
    std::uint64_t visible(const char* name, int n, int samples, int per_packet,
                          const MakeRay& make_ray, const OnSum& on_sum) {
        const auto start = now_ns();
        const auto* embree = std::get_if<embree::EmbreeScene>(&scene_);
        const std::uint64_t rays =
            embree != nullptr
                ? embree::visible(embree->handle(), n, samples, per_packet, make_ray, on_sum)
                : host_bvh::visible(std::get<host_bvh::HostBvhScene>(scene_), n, samples, make_ray,
                                    on_sum);
        passes_.add(name, now_ns() - start, rays);
        return rays;
    }

    PassTable& passes() { return passes_; }

  private:
    static std::int64_t now_ns() {
        return std::chrono::duration_cast<std::chrono::nanoseconds>(
                   std::chrono::steady_clock::now().time_since_epoch())
            .count();
    }

    const TracedScene& scene_;
    PassTable passes_;
};

class CpuBackend {
  public:
    /// `threads` 0: one a core. Our own BVH is always robust.
    CpuBackend(const Scene& scene, const embree::EmbreeSettings& settings,
               Tracer tracer = Tracer::embree);

    Tracer tracer() const { return static_cast<Tracer>(scene_.index()); }
    /// Throws where another tracer holds the scene.
    const embree::EmbreeScene& embree_scene() const;
    const SceneView& view() const;
    /// Moves the parts that have a motion and refits; nothing to do in a static scene.
    void set_time(double time_s);
    SceneBytes bytes() const;
    int threads() const { return threads_; }

    /// body(lane, thread, tile) for each tile, in any order on any thread. `thread` < threads().
    template <class Body>
    void for_tiles(int tiles, const Body& body) {
        task_order::before_loop();
        arena_->execute([&] {
            tbb::parallel_for(
                tbb::blocked_range<int>(0, tiles, 1),
                [&](const tbb::blocked_range<int>& range) {
                    task_order::task_begins();
                    const int thread = tbb::this_task_arena::current_thread_index();
                    for (int tile = range.begin(); tile < range.end(); ++tile)
                        body(lanes_[static_cast<std::size_t>(thread)], thread, tile);
                    task_order::task_ends();
                },
                tbb::simple_partitioner());
        });
        task_order::after_loop();
    }

    /// kernel(i) for i in [0, n), spread over the threads `block` at a time.
    template <class Kernel>
    void launch(const char* name, int n, const Kernel& kernel, int block = 1024) {
        for_tiles((n + block - 1) / block, [&](Lane& lane, int, int at) {
            const int begin = at * block;
            const int end = begin + block < n ? begin + block : n;
            lane.launch(name, end - begin, [&](int i) { kernel(begin + i); });
        });
    }

    /// Time of work that is no kernel (a refit), under its pass name.
    void add_pass(const char* name, std::int64_t ns) {
        lanes_.front().passes().add(name, ns * threads_);
    }

    /// Sums of all lanes since the last call; names in order of first use by thread 0.
    PassTable take_passes();

  private:
    int threads_;
    std::unique_ptr<tbb::task_arena> arena_;
    TracedScene scene_;
    std::vector<Lane> lanes_;
};

}  // namespace foverig
