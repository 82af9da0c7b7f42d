#include "renderer/pipelines/shade_tile.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/kernels/light_rays.h"
#include "renderer/kernels/shade_surface.h"

namespace foverig {
namespace {

/// Slots in queue order: neighbours stay neighbours, which is what rays to one point light want.
int order_by_pixel(TileScratch& s, int n) {
    int count = 0;
    for (int i = 0; i < n; ++i) {
        const auto at = static_cast<std::size_t>(i);
        s.slots[at] = s.hits[at].missed() ? kMiss : static_cast<std::uint32_t>(count++);
    }
    return count;
}

/// Slots by sampling pattern where every pixel is traced: the pixel decides its pattern, and slots
/// are sorted by it, in queue order within each. So a packet holds rays of one local direction from
/// nearby pixels, though neighbours use different ones (see kPatterns). Returns the slots given.
int order_dense(TileScratch& s, int n) {
    int starts[kPatterns + 1] = {};
    const auto takes_part = [&](std::size_t i) {
        return !s.hits[i].missed() && (s.sparse == nullptr || s.sparse[i] == 0);
    };
    const auto pattern = [&](std::size_t i) {
        return pattern_of(pixel_x(s.pixels[i]), pixel_y(s.pixels[i]));
    };
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i)
        if (takes_part(i)) ++starts[pattern(i) + 1];
    for (int p = 0; p < kPatterns; ++p) starts[p + 1] += starts[p];
    const int count = starts[kPatterns];
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
        s.slots[i] = kMiss;
        if (!takes_part(i)) continue;
        const int p = pattern(i);
        s.slots[i] = static_cast<std::uint32_t>(starts[p]);
        s.patterns[static_cast<std::size_t>(starts[p]++)] = p;
    }
    return count;
}

/// Sparse pixels of one pattern lie too far apart to share a packet. There a packet's worth of
/// neighbours in the queue takes one pattern, drawn anew each frame; within runs of a few packets
/// pixels are first put in order of depth, since most of them lie along silhouettes and rays from
/// both sides part at once.
constexpr int kSparseRun = 4 * embree::kPacket;

int order_sparse(TileScratch& s, const ShadingFrame& f, int n, int first_slot) {
    struct Entry {
        float depth;
        std::uint32_t pixel;
        bool operator<(const Entry& other) const {
            return depth < other.depth || (depth == other.depth && pixel < other.pixel);
        }
    };
    std::array<Entry, kSparseRun> run{};
    std::size_t held = 0;
    int slot = first_slot;
    const auto give_slots = [&] {
        std::sort(run.begin(), run.begin() + static_cast<std::ptrdiff_t>(held));
        for (std::size_t k = 0; k < held; ++k, ++slot) {
            const auto packet = static_cast<std::uint32_t>((slot - first_slot) / embree::kPacket);
            s.slots[run[k].pixel] = static_cast<std::uint32_t>(slot);
            s.patterns[static_cast<std::size_t>(slot)] =
                static_cast<int>(hash32(f.pattern_seed + packet) % kPatterns);
        }
        held = 0;
    };
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(n); ++i) {
        if (s.sparse[i] == 0 || s.hits[i].missed()) continue;
        run[held++] = {s.hits[i].t, i};
        if (held == run.size()) give_slots();
    }
    give_slots();
    return slot;
}

int order_by_pattern(TileScratch& s, const ShadingFrame& f, int n) {
    const int dense = order_dense(s, n);
    return s.sparse == nullptr ? dense : order_sparse(s, f, n, dense);
}

template <bool kTextures, bool kOcclusion, bool kLightBuffer>
void shade(embree::Lane& lane, TileScratch& s, const ShadingFrame& f, int n) {
    lane.launch("shade_surface", n,
                ShadeSurface<kTextures, kOcclusion, kLightBuffer>{
                    f.scene, f.eye, s.pixels.view(), s.hits.view(), s.slots.view(), s.surfaces(),
                    f.log2_pixel_width});
}

template <bool kTextures>
void shade_as_planned(embree::Lane& lane, TileScratch& s, const ShadingFrame& f, int n) {
    if (f.plan->on(Effect::ambient_occlusion)) return shade<kTextures, true, true>(lane, s, f, n);
    if (f.plan->on(Effect::light_buffer)) return shade<kTextures, false, true>(lane, s, f, n);
    return shade<kTextures, false, false>(lane, s, f, n);
}

void add_point_lights(embree::Lane& lane, TileScratch& s, const ShadingFrame& f, int n) {
    for (const PointLight& light : f.scene.point_lights) {
        s.rays.shadow += lane.visible("shadow_point", n, 1, PointLightRays{s.surfaces(), light},
                                      StoreVisible{s.surfaces()});
        lane.launch("shade_point_light", n, AddPointLight{s.surfaces(), light});
    }
}

void add_area_lights(embree::Lane& lane, TileScratch& s, const ShadingFrame& f, int n) {
    for (std::size_t i = 0; i < f.scene.area_lights.size; ++i) {
        const AreaLight& light = f.scene.area_lights[i];
        const vec3 normal = glm::cross(light.edge_u_m, light.edge_v_m);
        const float area_m2 = glm::length(normal);
        if (area_m2 <= 0.0F) continue;
        const PatternTable table = f.tables->area(i);
        const AreaLightRays rays{
            s.surfaces(), s.patterns.view(),         table,
            light,        normal * (1.0F / area_m2), area_m2 / static_cast<float>(table.samples)};
        s.rays.shadow += lane.visible("shadow_area", n, table.samples, rays,
                                      AddAreaLight{s.surfaces(), light.radiance});
    }
}

void add_occlusion(embree::Lane& lane, TileScratch& s, const ShadingFrame& f, int n) {
    const PatternTable table = f.tables->occlusion();
    const int samples = table.samples;
    const OcclusionRays rays{s.surfaces(), s.patterns.view(), table, f.occlusion_reach_m};
    s.rays.ao += lane.visible("ambient_occlusion", n, samples, rays,
                              StoreOcclusion{s.surfaces(), 1.0F / static_cast<float>(samples)});
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

int shade_tile(embree::Lane& lane, TileScratch& s, const ShadingFrame& f, int n) {
    if (n == 0) return 0;
    lane.closest("trace_primary", n, CameraRays{f.eye, s.pixels.view(), f.jitter_px},
                 StoreHit{s.hits.view()});
    s.rays.primary += static_cast<std::uint64_t>(n);
    s.sampled_pixels += static_cast<std::uint64_t>(n);
    int surfaces = 0;
    lane.launch("order_slots", 1, [&](int) {
        surfaces =
            f.plan->on(Effect::light_buffer) ? order_by_pattern(s, f, n) : order_by_pixel(s, n);
    });
    if (f.plan->on(Effect::textures))
        shade_as_planned<true>(lane, s, f, n);
    else
        shade_as_planned<false>(lane, s, f, n);
    if (f.plan->on(Effect::point_light)) add_point_lights(lane, s, f, surfaces);
    if (f.plan->on(Effect::area_light)) add_area_lights(lane, s, f, surfaces);
    if (f.plan->on(Effect::ambient_occlusion)) add_occlusion(lane, s, f, surfaces);
    return surfaces;
}

}  // namespace foverig
