#pragma once
// The anchor: bare Embree loops, written as fast as Embree allows, on the renderer's own rays,
// scene, threads and tiles. The fastest variant is what the renderer is measured against
// (PERFORMANCE.md 6).
#include <cstdint>
#include <span>
#include <vector>

#include "bench/anchor_rays.h"
#include "renderer/backends/cpu/cpu_backend.h"

namespace foverig::bench {

/// What a bare loop found: kept so that it can be proved right and that no work is optimised away.
struct PrimaryAnswers {
    std::vector<float> t;
    std::vector<std::uint32_t> geometry;  ///< RTC_INVALID_GEOMETRY_ID: nothing was hit
    std::vector<std::uint32_t> primitive;
};

struct PrimaryAnchor {
    const char* name;
    void (*trace)(RTCScene scene, const PixelQueue& queue, PrimaryAnswers& answers);
};

struct OcclusionAnchor {
    const char* name;
    /// Returns how many rays are occluded.
    std::uint64_t (*trace)(RTCScene scene, const RayList& rays);
};

std::span<const PrimaryAnchor> primary_anchors();
std::span<const OcclusionAnchor> occlusion_anchors();

/// Time of one run over all tiles. `busy_ms` is the threads' time in the loops over their number:
/// what the renderer's pass times are.
struct AnchorRun {
    double busy_ms = 0.0;
    double wall_ms = 0.0;
    std::uint64_t occluded = 0;
};

AnchorRun run_anchor(CpuBackend& backend, const PrimaryAnchor& anchor,
                     std::span<const PixelQueue> tiles);
AnchorRun run_anchor(CpuBackend& backend, const OcclusionAnchor& anchor,
                     std::span<const RayList> tiles);

}  // namespace foverig::bench
