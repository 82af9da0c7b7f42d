#pragma once
// The ray passes of one tile: primary rays of the queued pixels, surfaces, then every light that
// the plan has on. Shared by all pipelines that shade as Weier 2016 3.1 does.
#include "renderer/backends/cpu/cpu_backend.h"
#include "renderer/effects/plan.h"
#include "renderer/kernels/camera_rays.h"
#include "renderer/pipelines/frame/light_tables.h"
#include "renderer/pipelines/tile_scratch.h"

namespace foverig {

/// What is the same for all tiles of one eye's frame.
struct ShadingFrame {
    SceneView scene;
    const EffectPlan* plan = nullptr;
    const LightTables* tables = nullptr;
    EyeRays eye;
    vec2 jitter_px{0.0F};
    float log2_pixel_width = 0.0F;   ///< of a pixel's width at depth 1 m
    std::uint32_t pattern_seed = 0;  ///< of the frame: which patterns sparse pixels use
    float occlusion_reach_m = 0.0F;  ///< already without bound where the setting is 0
};

ShadingFrame make_shading_frame(const SceneView& scene, const EffectPlan& plan,
                                const LightTables& tables, const EyeView& eye,
                                const LightingSettings& lighting);

/// How many rays from one surface to an area light share a packet with those of its neighbours:
/// four points of one quarter of the lamp (see LightTables), or as many as divide the samples.
int lamp_samples_per_packet(int samples);

/// Traces and lights the first `n` pixels of `scratch.pixels`; afterwards `scratch.slots` says
/// where the surface records lie. Adds to the scratch's counts. Returns the number of surfaces.
int shade_tile(Lane& lane, TileScratch& scratch, const ShadingFrame& frame, int n);

}  // namespace foverig
