#include "bench/anchor.h"

#include <chrono>

namespace foverig::bench {
namespace {

double ms_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

/// One thread's share, on cache lines of its own.
struct alignas(128) Share {
    double busy_ms = 0.0;
    std::uint64_t occluded = 0;
};

template <class TraceTile>
AnchorRun run(CpuBackend& backend, std::size_t tiles, const TraceTile& trace_tile) {
    std::vector<Share> shares(static_cast<std::size_t>(backend.threads()));
    const auto start = std::chrono::steady_clock::now();
    backend.for_tiles(static_cast<int>(tiles), [&](Lane&, int thread, int tile) {
        const auto tile_start = std::chrono::steady_clock::now();
        const std::uint64_t occluded = trace_tile(static_cast<std::size_t>(tile));
        Share& share = shares[static_cast<std::size_t>(thread)];
        share.busy_ms += ms_since(tile_start);
        share.occluded += occluded;
    });
    AnchorRun result;
    result.wall_ms = ms_since(start);
    for (const Share& share : shares) {
        result.busy_ms += share.busy_ms / backend.threads();
        result.occluded += share.occluded;
    }
    return result;
}

}  // namespace

AnchorRun run_anchor(CpuBackend& backend, const PrimaryAnchor& anchor,
                     std::span<const PixelQueue> tiles) {
    const RTCScene scene = backend.embree_scene().handle();
    return run(backend, tiles.size(), [&](std::size_t tile) {
        static thread_local PrimaryAnswers answers;
        const std::size_t room = tiles[tile].pixels.size();
        if (answers.t.size() < room) {
            answers.t.resize(room);
            answers.geometry.resize(room);
            answers.primitive.resize(room);
        }
        anchor.trace(scene, tiles[tile], answers);
        return std::uint64_t{0};
    });
}

AnchorRun run_anchor(CpuBackend& backend, const OcclusionAnchor& anchor,
                     std::span<const RayList> tiles) {
    const RTCScene scene = backend.embree_scene().handle();
    return run(backend, tiles.size(),
               [&](std::size_t tile) { return anchor.trace(scene, tiles[tile]); });
}

}  // namespace foverig::bench
