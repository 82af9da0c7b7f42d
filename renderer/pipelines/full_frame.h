#pragma once
// The `full` pipeline where a pass takes the whole frame at once: one eye, every pixel. `Backend`
// is cuda/cuda_backend.cuh or its twin host_bvh/host_backend.h. Kernels and sample points are those
// of shade_tile.h, so the image is that of FullRenderer.
#include <cmath>
#include <vector>

#include "renderer/effects/plan.h"
#include "renderer/kernels/camera_rays.h"
#include "renderer/kernels/compose.h"
#include "renderer/kernels/frame_queue.h"
#include "renderer/kernels/light_rays.h"
#include "renderer/kernels/shade_surface.h"
#include "renderer/pipelines/light_tables.h"
#include "renderer/queue_size.h"

namespace foverig {

template <class Backend>
class FullFrame {
    template <class T>
    using Array = typename Backend::template Array<T>;

  public:
    /// Borrows all three; `backend` holds `scene` at the time of every frame.
    FullFrame(Backend& backend, const Scene& scene, const RenderSettings& settings)
        : backend_(backend),
          scene_(scene),
          settings_(settings),
          plan_(scene, settings),
          tables_(table_memory_, plan_, scene, settings.lighting),
          numerics_(memory_, 1) {
        if (on(Effect::area_light))
            area_points_ = Array<float>(memory_, table_floats(2, settings.lighting.area_samples));
        if (on(Effect::ambient_occlusion))
            directions_ = Array<float>(memory_, table_floats(3, settings.lighting.ao_samples));
    }

    /// Queues the passes of one frame; `image` waits for them.
    void render(const EyeView& view, std::uint32_t frame) {
        resize(view);
        if (on(Effect::light_buffer)) tables_.update(settings_.seed, frame);
        const int n = static_cast<int>(pixels_.size());
        const EyeRays eye(view);
        backend_.launch("queue_pixels", {n},
                        QueuePixels{view.width_px, view.height_px, pixels_.view()});
        backend_.closest("trace_primary", {n}, CameraRays{eye, pixels_.view(), {}},
                         StoreHit{hits_.view()});
        const QueueSize surfaces = backend_.number(
            "give_slots", n, SeesSurface{hits_.view()},
            GiveSlot{pixels_.view(), slots_.view(), own_slots_.view(), patterns_.view()});
        shade(n, eye,
              std::log2((view.tan_left + view.tan_right) / static_cast<float>(view.width_px)));
        if (on(Effect::point_light)) add_point_lights(surfaces);
        if (on(Effect::area_light)) add_area_lights(surfaces);
        if (on(Effect::ambient_occlusion)) add_occlusion(surfaces);
        compose(n, view.width_px);
    }

    /// Row by row from the top; w is 0.
    std::vector<Half4> image() { return backend_.download(image_); }
    NumericCounts numerics() { return backend_.download(numerics_).front(); }
    const EffectPlan& plan() const { return plan_; }

  private:
    bool on(Effect effect) const { return plan_.on(effect); }
    static std::size_t table_floats(int rows, int samples) {
        return static_cast<std::size_t>(rows * kPatterns * samples);
    }
    Surfaces records() { return {rows_.data(), static_cast<int>(pixels_.size())}; }

    void resize(const EyeView& view) {
        const std::size_t n =
            static_cast<std::size_t>(view.width_px) * static_cast<std::size_t>(view.height_px);
        if (pixels_.size() == n) return;
        const bool light = on(Effect::light_buffer);
        pixels_ = Array<PackedPixel>(memory_, n);
        hits_ = Array<Hit>(memory_, n);
        slots_ = Array<std::uint32_t>(memory_, n);
        own_slots_ = Array<int>(memory_, on(Effect::ambient_occlusion) ? n : 0);
        patterns_ = Array<int>(memory_, light ? n : 0);
        rows_ =
            Array<float>(memory_, n * static_cast<std::size_t>(light ? kRows : kRowsWithoutLight));
        image_ = Array<Half4>(memory_, n);
    }

    void shade(int n, const EyeRays& eye, float log2_pixel_width) {
        const auto run = [&]<bool kTextures, bool kOcclusion, bool kLight>() {
            backend_.launch("shade_surface", {n},
                            ShadeSurface<kTextures, kOcclusion, kLight>{
                                backend_.view(), eye, pixels_.view(), hits_.view(), slots_.view(),
                                records(), log2_pixel_width});
        };
        const auto run_lit = [&]<bool kTextures>() {
            if (on(Effect::ambient_occlusion))
                return run.template operator()<kTextures, true, true>();
            if (on(Effect::light_buffer)) return run.template operator()<kTextures, false, true>();
            run.template operator()<kTextures, false, false>();
        };
        if (on(Effect::textures))
            run_lit.template operator()<true>();
        else
            run_lit.template operator()<false>();
    }

    void add_point_lights(QueueSize surfaces) {
        for (const PointLight& light : scene_.point_lights) {
            backend_.visible("shadow_point", surfaces, 1, PointLightRays{records(), light},
                             StoreVisible{records()});
            backend_.launch("shade_point_light", surfaces, AddPointLight{records(), light});
        }
    }

    void add_area_lights(QueueSize surfaces) {
        for (std::size_t i = 0; i < scene_.area_lights.size(); ++i) {
            const AreaLight& light = scene_.area_lights[i];
            const vec3 normal = glm::cross(light.edge_u_m, light.edge_v_m);
            const float area_m2 = glm::length(normal);
            if (area_m2 <= 0.0F) continue;
            const PatternTable table = tables_.area(i);
            backend_.upload(area_points_, View<const float>{table.rows, area_points_.size()});
            const AreaLightRays rays{
                records(), patterns_.view(),          {area_points_.data(), table.samples},
                light,     normal * (1.0F / area_m2), area_m2 / static_cast<float>(table.samples)};
            backend_.visible("shadow_area", surfaces, table.samples, rays,
                             AddAreaLight{records(), light.radiance});
        }
    }

    void add_occlusion(QueueSize surfaces) {
        const PatternTable table = tables_.occlusion();
        backend_.upload(directions_, View<const float>{table.rows, directions_.size()});
        const double radius_m = settings_.lighting.ao_radius_m;
        const OcclusionRays rays{records(),
                                 own_slots_.view(),
                                 patterns_.view(),
                                 {directions_.data(), table.samples},
                                 radius_m > 0.0 ? static_cast<float>(radius_m) : 1.0e30F};
        backend_.visible("ambient_occlusion", surfaces, table.samples, rays,
                         StoreOcclusion{records(), 1.0F / static_cast<float>(table.samples)});
    }

    void compose(int n, int width_px) {
        const auto run = [&]<bool kOcclusion, bool kLight>() {
            backend_.launch("compose", {n},
                            ComposePixels<kOcclusion, kLight>{
                                records(), pixels_.view(), slots_.view(), scene_.ambient,
                                scene_.background, image_.view(), width_px, numerics_.data()});
        };
        if (on(Effect::ambient_occlusion)) return run.template operator()<true, true>();
        if (on(Effect::light_buffer)) return run.template operator()<false, true>();
        run.template operator()<false, false>();
    }

    Backend& backend_;
    const Scene& scene_;
    RenderSettings settings_;
    EffectPlan plan_;
    EffectMemory table_memory_;  ///< of the tables on the host
    LightTables tables_;
    MemoryCount memory_;  ///< where the backend's kernels run
    Array<NumericCounts> numerics_;
    Array<float> area_points_;  ///< of the light in hand
    Array<float> directions_;
    Array<PackedPixel> pixels_;
    Array<Hit> hits_;
    Array<std::uint32_t> slots_;
    Array<int> own_slots_;
    Array<int> patterns_;
    Array<float> rows_;
    Array<Half4> image_;
};

}  // namespace foverig
