#include "bench/traced_frame.h"

#include <atomic>
#include <cmath>

#include "bench/anchor.h"
#include "renderer/foveation/foveal_function.h"
#include "renderer/kernels/light_rays.h"

namespace foverig::bench {
namespace {

bool is_queued(const Mask& mask, std::size_t x, std::size_t y) {
    return mask.pixels.empty() || mask.pixels[y * static_cast<std::size_t>(mask.width_px) + x] != 0;
}

void pad_to_packets(std::vector<PackedPixel>& pixels) {
    while (pixels.size() % 16 != 0) pixels.push_back(pixels.back());
}

}  // namespace

std::vector<PixelQueue> queues_of(const EyeInput& eye, const Selection& selection) {
    const TileGrid grid{eye.view.width_px, eye.view.height_px};
    const EyeRays rays(eye.view);
    const vec3 gaze = glm::normalize(eye.view.world_from_eye * eye.gaze);
    const float r0_rad = glm::radians(selection.r0_deg);
    std::vector<PixelQueue> queues;
    for (int tile = 0; tile < grid.count(); tile += selection.tile_stride) {
        const TileRect rect = grid.rect(tile);
        PixelQueue queue;
        queue.eye = rays;
        for (const std::uint16_t at : kCoherentOrder) {
            const int x = at % kTile;
            const int y = at / kTile;
            if (x >= rect.width || y >= rect.height) continue;
            const auto px = static_cast<std::uint32_t>(rect.x0 + x);
            const auto py = static_cast<std::uint32_t>(rect.y0 + y);
            if (!is_queued(selection.mask, px, py)) continue;
            queue.pixels.push_back(pack_pixel(px, py));
            if (selection.mask.pixels.empty()) continue;
            const vec3 d =
                rays.direction(static_cast<float>(px) + 0.5F, static_cast<float>(py) + 0.5F);
            const float eccentricity =
                fast_angle_rad(glm::length(glm::cross(gaze, d)), glm::dot(gaze, d));
            queue.sparse.push_back(eccentricity > r0_rad ? 1 : 0);
        }
        queue.count = static_cast<int>(queue.pixels.size());
        pad_to_packets(queue.pixels);
        queues.push_back(std::move(queue));
    }
    return queues;
}

TracedFrame::TracedFrame(PipelineCore& core, const FrameInput& input, const Selection& selection)
    : core_(core), input_(input), queues_(queues_of(input.eyes[0], selection)) {}

int TracedFrame::shade(Lane& lane, TileScratch& scratch, int tile) {
    const PixelQueue& queue = queues_[static_cast<std::size_t>(tile)];
    std::copy(queue.pixels.begin(), queue.pixels.end(), scratch.pixels.data());
    scratch.sparse = queue.sparse.empty() ? nullptr : queue.sparse.data();
    return shade_tile(lane, scratch, frame_, queue.count);
}

FrameStats TracedFrame::trace() {
    core_.begin_frame(input_);
    frame_ = core_.shading_frame(input_.eyes[0].view);
    core_.backend().for_tiles(
        static_cast<int>(queues_.size()),
        [&](Lane& lane, int thread, int tile) { shade(lane, core_.scratch(thread), tile); });
    return core_.end_frame(0);
}

/// use(n, samples, samples that share a packet, functor that makes the rays), as shade_tile.cpp
/// traces them.
template <class Use>
void TracedFrame::for_visibility_rays(TileScratch& s, int surfaces, const Use& use) const {
    if (core_.plan().on(Effect::point_light))
        use(surfaces, 1, 1, PointLightRays{s.surfaces(), frame_.scene.point_lights[0]});
    if (core_.plan().on(Effect::area_light)) {
        const AreaLight& light = frame_.scene.area_lights[0];
        const vec3 normal = glm::cross(light.edge_u_m, light.edge_v_m);
        const float area_m2 = glm::length(normal);
        const PatternTable table = frame_.tables->area(0);
        use(surfaces, table.samples, lamp_samples_per_packet(table.samples),
            AreaLightRays{s.surfaces(), s.patterns.view(), table, light, normal * (1.0F / area_m2),
                          area_m2 / static_cast<float>(table.samples)});
    }
    if (core_.plan().on(Effect::ambient_occlusion)) {
        const PatternTable table = frame_.tables->occlusion();
        for (const OcclusionQueue::Part& part : {s.occlusion.dense(), s.occlusion.sparse()})
            use(static_cast<int>(part.slots.size), table.samples, 1,
                OcclusionRays{s.surfaces(), part.slots, part.patterns, table,
                              frame_.occlusion_reach_m});
    }
}

std::vector<RayList> TracedFrame::visibility_rays() {
    std::vector<RayList> lists(queues_.size());
    trace();
    core_.backend().for_tiles(static_cast<int>(queues_.size()), [&](Lane& lane, int thread,
                                                                    int tile) {
        TileScratch& scratch = core_.scratch(thread);
        RayList& list = lists[static_cast<std::size_t>(tile)];
        for_visibility_rays(scratch, shade(lane, scratch, tile),
                            [&](int n, int samples, int per_packet, const auto& make_ray) {
                                const int slots = 16 / per_packet;
                                for (int base = 0; base < n; base += slots) {
                                    for (int lane_of = 0; lane_of < samples * slots; ++lane_of) {
                                        const int slot = base + lane_of % slots;
                                        if (slot >= n) continue;
                                        const WeightedRay ray = make_ray(slot, lane_of / slots);
                                        if (ray.weight > 0.0F) list.add(ray.ray);
                                    }
                                }
                            });
    });
    core_.end_frame(0);
    return lists;
}

double TracedFrame::wrong_primary_share(const PrimaryAnchor& anchor) {
    const RTCScene scene = core_.backend().embree_scene().handle();
    std::atomic<std::uint64_t> wrong{0};
    std::atomic<std::uint64_t> rays{0};
    core_.backend().for_tiles(
        static_cast<int>(queues_.size()), [&](Lane& lane, int thread, int tile) {
            TileScratch& scratch = core_.scratch(thread);
            const PixelQueue& queue = queues_[static_cast<std::size_t>(tile)];
            shade(lane, scratch, tile);
            const std::size_t room = queue.pixels.size();
            PrimaryAnswers answers{std::vector<float>(room), std::vector<std::uint32_t>(room),
                                   std::vector<std::uint32_t>(room)};
            anchor.trace(scene, queue, answers);
            for (std::size_t i = 0; i < static_cast<std::size_t>(queue.count); ++i) {
                const Hit& hit = scratch.hits[i];
                const bool missed = answers.geometry[i] == RTC_INVALID_GEOMETRY_ID;
                const bool far_off = !missed && std::abs(answers.t[i] - hit.t) > 1.0e-5F * hit.t;
                wrong += missed != hit.missed() || far_off ? 1U : 0U;
            }
            rays += static_cast<std::uint64_t>(queue.count);
        });
    core_.end_frame(0);
    return rays > 0 ? static_cast<double>(wrong) / static_cast<double>(rays) : 0.0;
}

std::uint64_t TracedFrame::occluded_by_packets() {
    std::atomic<std::uint64_t> occluded{0};
    core_.backend().for_tiles(static_cast<int>(queues_.size()), [&](Lane& lane, int thread,
                                                                    int tile) {
        TileScratch& scratch = core_.scratch(thread);
        for_visibility_rays(scratch, shade(lane, scratch, tile),
                            [&](int n, int samples, int per_packet, const auto& make_ray) {
                                float open = 0.0F;
                                const auto unweighted = [&](int slot, int sample) {
                                    WeightedRay ray = make_ray(slot, sample);
                                    ray.weight = ray.weight > 0.0F ? 1.0F : 0.0F;
                                    return ray;
                                };
                                const std::uint64_t traced = embree::visible(
                                    core_.backend().embree_scene().handle(), n, samples, per_packet,
                                    unweighted, [&](int, float sum) { open += sum; });
                                occluded += traced - static_cast<std::uint64_t>(open);
                            });
    });
    core_.end_frame(0);
    return occluded;
}

}  // namespace foverig::bench
