#pragma once
// What foverig_gpu measures of one scene; each gives a row for the results.
#include <nlohmann/json.hpp>

#include "bench/gpu/gpu_scene.h"

namespace foverig::gpu {

using Json = nlohmann::ordered_json;

struct GpuSettings {
    std::uint32_t rays = 10'000'000;        ///< of a timed batch
    std::uint32_t parity_rays = 1'000'000;  ///< compared, of each kind
    int repetitions = 7;
    int paced_frames = 10'000;  ///< of the first scene, at 75 Hz; 0: none
};

/// Three named tolerances between CUDA and host-bvh.
struct Tolerances {
    std::uint64_t wrong_hits = 0;      ///< that no named tie of bench/agreement.h explains
    double pixels_apart_share = 5e-3;  ///< pixels that differ by more than 0.01 in all channels'
                                       ///< sum: where a hit or a shadow fell on the other side
    double mean_apart = 1e-3;          ///< mean over channels of |difference|
};

/// Hits of five kinds of rays, closest and any, and frame_parity(). Key "pass" says whether all
/// tolerances hold, "may_be_timed" whether at least every hit is right and every frame sound.
Json parity(const GpuScene& scene, const GpuSettings& settings, const Tolerances& tolerances = {});

/// Mrays/s of primary, shadow, AO and diffuse rays, one batch each, and of the diffuse ones by a
/// binary BVH; medians. And what a ray of each kind reads.
Json ray_rates(const GpuScene& scene, const GpuSettings& settings);

/// A short flight of `full` and `reprojected`, both eyes, every kind of light, against the same
/// passes on the host; and each frame as a graph against single launches, to the bit. "sound":
/// these are equal, and no number was lost.
Json frame_parity(const GpuScene& scene, const Tolerances& tolerances);

/// Point light, area light of 8 samples, AO 16: `full` and `reprojected`, one eye and both at the
/// DK2's 1182 x 1464 and both at 3840 x 2160; median frame and pass times.
Json frames(const GpuScene& scene, const GpuSettings& settings);

/// `reprojected` with AO 16, both eyes, begun at each VSync of 75 Hz.
Json pacing(const GpuScene& scene, int frames);

/// Whether the device's refit ends with the bytes of the host's, launched one by one and as a graph
/// (key "pass"), and if so its times. The scene has a part that moves.
Json refit(const Scene& scene, const GpuSettings& settings);

}  // namespace foverig::gpu
