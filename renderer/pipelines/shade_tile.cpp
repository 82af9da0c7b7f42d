#include "renderer/pipelines/shade_tile.h"

#include <cmath>

#include "renderer/kernels/light_rays.h"
#include "renderer/kernels/shade_surface.h"

namespace foverig {
namespace {

/// Slots in queue order: neighbours stay neighbours. Returns the slots given.
int give_slots(TileScratch& s, int n, bool patterns) {
    int count = 0;
    for (int i = 0; i < n; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (s.hits[at].missed()) {
            s.slots[at] = kMiss;
            continue;
        }
        if (patterns)
            s.patterns[static_cast<std::size_t>(count)] =
                pattern_of(pixel_x(s.pixels[at]), pixel_y(s.pixels[at]));
        s.slots[at] = static_cast<std::uint32_t>(count++);
    }
    return count;
}

template <bool kTextures, bool kOcclusion, bool kLightBuffer>
void shade(Lane& lane, TileScratch& s, const ShadingFrame& f, int n) {
    lane.launch("shade_surface", n,
                ShadeSurface<kTextures, kOcclusion, kLightBuffer>{
                    f.scene, f.eye, s.pixels.view(), s.hits.view(), s.slots.view(), s.surfaces(),
                    f.log2_pixel_width});
}

template <bool kTextures>
void shade_as_planned(Lane& lane, TileScratch& s, const ShadingFrame& f, int n) {
    if (f.plan->on(Effect::ambient_occlusion)) return shade<kTextures, true, true>(lane, s, f, n);
    if (f.plan->on(Effect::light_buffer)) return shade<kTextures, false, true>(lane, s, f, n);
    return shade<kTextures, false, false>(lane, s, f, n);
}

void add_point_lights(Lane& lane, TileScratch& s, const ShadingFrame& f, int n) {
    for (const PointLight& light : f.scene.point_lights) {
        s.rays.shadow += lane.visible("shadow_point", n, 1, 1, PointLightRays{s.surfaces(), light},
                                      StoreVisible{s.surfaces()});
        lane.launch("shade_point_light", n, AddPointLight{s.surfaces(), light});
    }
}

void add_area_lights(Lane& lane, TileScratch& s, const ShadingFrame& f, int n) {
    for (std::size_t i = 0; i < f.scene.area_lights.size; ++i) {
        const AreaLight& light = f.scene.area_lights[i];
        const vec3 normal = glm::cross(light.edge_u_m, light.edge_v_m);
        const float area_m2 = glm::length(normal);
        if (area_m2 <= 0.0F) continue;
        const PatternTable table = f.tables->area(i);
        const AreaLightRays rays{
            s.surfaces(), s.patterns.view(),         table,
            light,        normal * (1.0F / area_m2), area_m2 / static_cast<float>(table.samples)};
        s.rays.shadow +=
            lane.visible("shadow_area", n, table.samples, lamp_samples_per_packet(table.samples),
                         rays, AddAreaLight{s.surfaces(), light.radiance});
    }
}

void add_occlusion(Lane& lane, TileScratch& s, const ShadingFrame& f, int n) {
    OcclusionQueue& queue = s.occlusion;
    lane.launch("order_occlusion", 1, [&](int) {
        queue.order(s.surfaces(), s.pixels.view(), s.slots.view(), s.sparse, n, f.pattern_seed);
    });
    const PatternTable table = f.tables->occlusion();
    for (const OcclusionQueue::Part& part : {queue.dense(), queue.sparse()}) {
        const OcclusionRays rays{s.surfaces(), part.slots, part.patterns, table,
                                 f.occlusion_reach_m};
        const StoreOcclusionAt store{{s.surfaces(), 1.0F / static_cast<float>(table.samples)},
                                     part.slots};
        s.rays.ao += lane.visible("ambient_occlusion", static_cast<int>(part.slots.size),
                                  table.samples, 1, rays, store);
    }
}

}  // namespace

ShadingFrame make_shading_frame(const SceneView& scene, const EffectPlan& plan,
                                const LightTables& tables, const EyeView& eye,
                                const LightingSettings& lighting) {
    ShadingFrame f;
    f.scene = scene;
    f.plan = &plan;
    f.tables = &tables;
    f.eye = EyeRays(eye);
    f.log2_pixel_width =
        std::log2((eye.tan_left + eye.tan_right) / static_cast<float>(eye.width_px));
    f.occlusion_reach_m =
        lighting.ao_radius_m > 0.0 ? static_cast<float>(lighting.ao_radius_m) : 1.0e30F;
    return f;
}

int lamp_samples_per_packet(int samples) {
    int count = 4;
    while (samples % count != 0) count /= 2;
    return count;
}

int shade_tile(Lane& lane, TileScratch& s, const ShadingFrame& f, int n) {
    if (n == 0) return 0;
    lane.closest("trace_primary", n, CameraRays{f.eye, s.pixels.view(), f.jitter_px},
                 StoreHit{s.hits.view()});
    s.rays.primary += static_cast<std::uint64_t>(n);
    s.sampled_pixels += static_cast<std::uint64_t>(n);
    int surfaces = 0;
    lane.launch("give_slots", 1,
                [&](int) { surfaces = give_slots(s, n, f.plan->on(Effect::area_light)); });
    if (f.plan->on(Effect::textures))
        shade_as_planned<true>(lane, s, f, n);
    else
        shade_as_planned<false>(lane, s, f, n);
    if (f.plan->on(Effect::point_light)) add_point_lights(lane, s, f, surfaces);
    if (f.plan->on(Effect::area_light)) add_area_lights(lane, s, f, surfaces);
    if (f.plan->on(Effect::ambient_occlusion)) add_occlusion(lane, s, f, n);
    return surfaces;
}

}  // namespace foverig
