#pragma once
// The CPU mirror of the renderer: Embree traces, TBB spreads tiles over threads. A `Lane` runs the
// passes of one tile on one thread; the same pass code would run them over a whole frame on a GPU.
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <vector>

#include "renderer/backends/embree/embree_scene.h"
#include "renderer/backends/embree/packets.h"
#include "renderer/pass_table.h"

namespace foverig::embree {

/// Runs named passes one after the other and keeps their time.
class Lane {
  public:
    explicit Lane(const EmbreeScene& scene) : scene_(scene) {}

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
        embree::closest(scene_.handle(), scene_.first_triangles(), n, make_ray, on_hit);
        passes_.add(name, now_ns() - start, static_cast<std::uint64_t>(n));
    }

    /// Returns the number of rays traced.
    template <class MakeRay, class OnSum>
    std::uint64_t visible(const char* name, int n, int samples, const MakeRay& make_ray,
                          const OnSum& on_sum) {
        const auto start = now_ns();
        const std::uint64_t rays = embree::visible(scene_.handle(), n, samples, make_ray, on_sum);
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

    const EmbreeScene& scene_;
    PassTable passes_;
};

class CpuBackend {
  public:
    /// `threads` 0: one a core.
    CpuBackend(const Scene& scene, const EmbreeSettings& settings);

    EmbreeScene& scene() { return scene_; }
    const EmbreeScene& scene() const { return scene_; }
    int threads() const { return threads_; }

    /// body(lane, thread, tile) for each tile, in any order on any thread. `thread` < threads().
    template <class Body>
    void for_tiles(int tiles, const Body& body) {
        arena_->execute([&] {
            tbb::parallel_for(
                tbb::blocked_range<int>(0, tiles, 1),
                [&](const tbb::blocked_range<int>& range) {
                    const int thread = tbb::this_task_arena::current_thread_index();
                    for (int tile = range.begin(); tile < range.end(); ++tile)
                        body(lanes_[static_cast<std::size_t>(thread)], thread, tile);
                },
                tbb::simple_partitioner());
        });
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
    EmbreeScene scene_;
    std::vector<Lane> lanes_;
};

}  // namespace foverig::embree
