#include "renderer/pipelines/reference_tile.h"

namespace foverig {
namespace {

constexpr std::size_t kStride = TileScratch::kStride;

/// The passes of one bounce over the paths that still run.
class Bounce {
  public:
    Bounce(Lane& lane, TileScratch& tile, PathScratch& scratch, const ShadingFrame& frame,
           const PathSampler& sampler, std::uint32_t bounce, bool last)
        : lane_(lane),
          tile_(tile),
          scratch_(scratch),
          frame_(frame),
          paths_(scratch.states(tile)),
          vertex_{paths_, std::as_const(scratch.path_of).view(), sampler, bounce},
          bounce_(bounce),
          last_(last) {}

    /// Takes the `running` paths one vertex on; returns how many go on from there.
    int run(int running) {
        trace(running);
        const int surfaces = give_slots(running);
        lane_.launch(
            "gather_misses", running,
            GatherMisses{paths_, std::as_const(tile_.slots).view(), frame_.scene.background});
        if (frame_.plan->on(Effect::textures))
            shade<true>(running);
        else
            shade<false>(running);
        add_lights(surfaces);
        leave(surfaces);
        return last_ ? 0 : requeue(surfaces);
    }

  private:
    void trace(int running) {
        const char* const name = bounce_ == 0 ? "trace_primary" : "trace_bounce";
        lane_.closest(name, running, PathRays{paths_}, StoreHit{tile_.hits.view()});
        if (bounce_ == 0) {
            tile_.rays.primary += static_cast<std::uint64_t>(running);
            return;
        }
        std::uint64_t mirrored = 0;
        for (int i = 0; i < running; ++i) mirrored += paths_.mirrored[paths_.path(i)];
        tile_.rays.reflection += mirrored;
        tile_.rays.probe += static_cast<std::uint64_t>(running) - mirrored;
    }

    int give_slots(int running) {
        std::uint32_t count = 0;
        for (int i = 0; i < running; ++i) {
            const auto at = static_cast<std::size_t>(i);
            tile_.slots[at] = kMiss;
            if (tile_.hits[at].missed()) continue;
            scratch_.path_of[count] = paths_.queue[at];
            scratch_.triangle_of[count] = tile_.hits[at].triangle;
            tile_.slots[at] = count++;
        }
        // A packet asks for lanes past the end: let them repeat a path that exists.
        for (std::uint32_t i = count; i < count + embree::kPacket && i < kStride; ++i)
            scratch_.path_of[i] = 0;
        return static_cast<int>(count);
    }

    template <bool kTextures>
    void shade(int running) {
        const auto launch = [&]<bool kOcclusion, bool kLightBuffer>() {
            lane_.launch("shade_surface", running,
                         ShadeVertex<kTextures, kOcclusion, kLightBuffer>{
                             frame_.scene, paths_, std::as_const(tile_.hits).view(),
                             std::as_const(tile_.slots).view(), tile_.surfaces(),
                             frame_.log2_pixel_width, bounce_ == 0});
        };
        as_planned(launch);
    }

    void add_lights(int surfaces) {
        const Surfaces s = tile_.surfaces();
        if (frame_.plan->on(Effect::point_light)) {
            for (const PointLight& light : frame_.scene.point_lights) {
                tile_.rays.shadow += lane_.visible("shadow_point", surfaces, 1, 1,
                                                   PointLightRays{s, light}, StoreVisible{s});
                lane_.launch("shade_point_light", surfaces, AddPointLight{s, light});
            }
        }
        if (frame_.plan->on(Effect::area_light)) {
            for (std::size_t i = 0; i < frame_.scene.area_lights.size; ++i) {
                const AreaLight& light = frame_.scene.area_lights[i];
                const vec3 normal = glm::cross(light.edge_u_m, light.edge_v_m);
                const float area_m2 = glm::length(normal);
                if (area_m2 <= 0.0F) continue;
                const PathAreaLightRays rays{
                    s,       vertex_,
                    light,   normal * (1.0F / area_m2),
                    area_m2, kLightPair + 2 * static_cast<std::uint32_t>(i)};
                tile_.rays.shadow +=
                    lane_.visible("shadow_area", surfaces, PathAreaLightRays::kSamples, 1, rays,
                                  AddAreaLight{s, light.radiance});
            }
        }
        if (frame_.plan->on(Effect::ambient_occlusion))
            tile_.rays.ao += lane_.visible("ambient_occlusion", surfaces, 1, 1,
                                           PathOcclusionRays{s, vertex_, frame_.occlusion_reach_m},
                                           StoreOcclusion{s, 1.0F});
    }

    void leave(int surfaces) {
        const auto launch = [&]<bool kOcclusion, bool kLightBuffer>() {
            lane_.launch("leave_vertex", surfaces,
                         LeaveVertex<kOcclusion, kLightBuffer>{
                             frame_.scene, tile_.surfaces(), vertex_,
                             std::as_const(scratch_.triangle_of).view(), last_});
        };
        as_planned(launch);
    }

    int requeue(int surfaces) {
        int count = 0;
        for (int slot = 0; slot < surfaces; ++slot) {
            const std::uint32_t path = scratch_.path_of[static_cast<std::size_t>(slot)];
            const vec3& t = paths_.throughput[path];
            if (t.x + t.y + t.z > 0.0F) paths_.queue[static_cast<std::size_t>(count++)] = path;
        }
        return count;
    }

    template <class Launch>
    void as_planned(const Launch& launch) const {
        if (frame_.plan->on(Effect::ambient_occlusion))
            launch.template operator()<true, true>();
        else if (frame_.plan->on(Effect::light_buffer))
            launch.template operator()<false, true>();
        else
            launch.template operator()<false, false>();
    }

    Lane& lane_;
    TileScratch& tile_;
    PathScratch& scratch_;
    const ShadingFrame& frame_;
    PathStates paths_;
    VertexSampler vertex_;
    std::uint32_t bounce_;
    bool last_;
};

}  // namespace

PathScratch::PathScratch(MemoryCount& memory)
    : queue(memory, kStride),
      vectors(memory, 4 * kStride),
      mirrored(memory, kStride),
      path_of(memory, kStride),
      triangle_of(memory, kStride) {}

PathStates PathScratch::states(const TileScratch& tile) {
    vec3* const p = vectors.data();
    return {tile.pixels.view(),
            queue.view(),
            {p, kStride},
            {p + kStride, kStride},
            {p + 2 * kStride, kStride},
            {p + 3 * kStride, kStride},
            mirrored.view()};
}

void trace_paths(Lane& lane, TileScratch& tile, PathScratch& scratch, const ShadingFrame& frame,
                 int n, const PathSampler& sampler, int max_bounces, const HalfSums& sums) {
    const PathStates paths = scratch.states(tile);
    lane.launch("begin_paths", n, BeginPaths{frame.eye, sampler, paths});
    int running = n;
    for (int bounce = 0; bounce <= max_bounces && running > 0; ++bounce)
        running = Bounce(lane, tile, scratch, frame, sampler, static_cast<std::uint32_t>(bounce),
                         bounce == max_bounces)
                      .run(running);
    lane.launch("accumulate", n, AccumulatePaths{paths, sums, &tile.numerics});
}

}  // namespace foverig
