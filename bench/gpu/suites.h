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
};

/// Three named tolerances between CUDA and host-bvh.
struct Tolerances {
    std::uint64_t wrong_hits = 0;      ///< that no named tie of bench/agreement.h explains
    double pixels_apart_share = 5e-3;  ///< pixels that differ by more than 0.01 in all channels'
                                       ///< sum: where a hit or a shadow fell on the other side
    double mean_apart = 1e-3;          ///< mean over channels of |difference|
};

/// Hits of five kinds of rays, closest and any, and an image of `full` with every kind of light.
/// Key "pass" says whether all tolerances hold.
Json parity(const GpuScene& scene, const GpuSettings& settings, const Tolerances& tolerances = {});

/// Mrays/s of primary, shadow, AO and diffuse rays, one batch each; medians.
Json ray_rates(const GpuScene& scene, const GpuSettings& settings);

/// `full` at the DK2's 1182 x 1464, one eye: point light, area light 8, AO 16; median frame and
/// pass times.
Json full_frames(const GpuScene& scene, const GpuSettings& settings);

}  // namespace foverig::gpu
