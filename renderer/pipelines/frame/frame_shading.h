#pragma once
// Shading where a pass takes a whole queue at once, of both eyes: `Backend` is
// cuda/cuda_backend.cuh or its twin host_bvh/host_backend.h. Kernels and sample points are those of
// shade_tile.h; only the order of occlusion rays differs, since lanes of a GPU need not share a
// direction.
#include <array>
#include <cmath>

#include "renderer/counts.h"
#include "renderer/effects/memory.h"
#include "renderer/kernels/camera_rays.h"
#include "renderer/kernels/frame_eyes.h"
#include "renderer/kernels/frame_queue.h"
#include "renderer/kernels/secondary_rays.h"
#include "renderer/kernels/shade_surface.h"
#include "renderer/pipelines/frame/light_tables.h"
#include "renderer/queue_size.h"
#include "renderer/settings.h"

namespace foverig {

/// The eyes of a frame: one or two, of one size.
struct FrameEyes {
    int count = 1;
    std::array<EyeView, kMostEyes> view;
};

inline constexpr const char* kPrimaryPass = "trace_primary";
inline constexpr const char* kSecondaryPass = "trace_secondary";

template <class Backend>
class FrameShading {
    template <class T>
    using Array = typename Backend::template Array<T>;

  public:
    /// Borrows all; `backend` holds `scene` at the time of every frame.
    FrameShading(Backend& backend, const Scene& scene, const RenderSettings& settings,
                 const EffectPlan& plan, EffectMemory& memory)
        : backend_(backend),
          scene_(scene),
          settings_(settings),
          plan_(plan),
          memory_(memory),
          tables_(table_memory_, plan, scene, settings.lighting),
          lamp_points_(memory.of(Effect::area_light), tables_.areas().size),
          directions_(memory.of(Effect::ambient_occlusion), tables_.occlusions().size),
          numerics_(memory.base(), 1) {
        if (on(Effect::point_light)) samples_.points = backend.view().point_lights;
        if (on(Effect::area_light)) add_lamps();
        if (on(Effect::ambient_occlusion)) samples_.ao_samples = settings.lighting.ao_samples;
    }

    /// Room for a queue of `pixels`. Returns whether there was room already.
    bool reserve(std::size_t pixels) {
        if (slots_.size() == pixels) return true;
        const bool light = on(Effect::light_buffer);
        MemoryCount& base = memory_.base();
        hits_ = {};
        slots_ = {};
        patterns_ = {};
        rows_ = {};
        hits_ = Array<Hit>(base, pixels);
        slots_ = Array<std::uint32_t>(base, pixels);
        patterns_ = Array<int>(memory_.of(Effect::light_buffer), light ? pixels : 0);
        rows_ = Array<float>(base,
                             pixels * static_cast<std::size_t>(light ? kRows : kRowsWithoutLight));
        return false;
    }

    /// The frame's sample points. Before any pass of the frame: it copies from the host.
    void draw_samples(std::uint32_t frame) {
        if (!on(Effect::light_buffer)) return;
        tables_.update(settings_.seed, frame);
        if (!tables_.areas().empty()) backend_.upload(lamp_points_, tables_.areas());
        if (!tables_.occlusions().empty()) backend_.upload(directions_, tables_.occlusions());
    }

    /// Traces and shades the queued pixels: then surfaces() holds what slots() names.
    void shade(QueueSize queue, View<const PackedPixel> pixels, const FrameEyes& eyes,
               vec2 jitter_px) {
        const auto rays = [&](int eye) {
            return CameraRays{EyeRays(eyes.view[static_cast<std::size_t>(eye)]), pixels, jitter_px};
        };
        backend_.closest(kPrimaryPass, queue,
                         EyeOfPixel<CameraRays>{{rays(0), rays(1)}, pixels.data},
                         StoreHit{hits_.view()});
        const QueueSize surfaces =
            backend_.number("give_slots", queue, SeesSurface{hits_.view()},
                            GiveSlot{pixels, slots_.view(), patterns_.view()});
        run_shade(queue, pixels, eyes);
        if (samples_.count() > 0) run_secondary(surfaces);
    }

    Surfaces surfaces() { return {rows_.data(), static_cast<int>(slots_.size())}; }
    View<const std::uint32_t> slots() const { return slots_.view(); }
    NumericCounts* numerics() { return numerics_.data(); }

    /// Of the frames since the last call; waits.
    NumericCounts take_numerics() {
        const NumericCounts counts = backend_.download(numerics_).front();
        const NumericCounts none;
        backend_.upload(numerics_, View<const NumericCounts>{&none, 1});
        return counts;
    }
    const SecondarySamples& samples() const { return samples_; }
    const Scene& scene() const { return scene_; }

  private:
    bool on(Effect effect) const { return plan_.on(effect); }

    void add_lamps() {
        std::vector<Lamp> lamps;
        for (std::size_t i = 0; i < scene_.area_lights.size(); ++i) {
            const AreaLight& light = scene_.area_lights[i];
            const vec3 normal = glm::cross(light.edge_u_m, light.edge_v_m);
            const float area_m2 = glm::length(normal);
            if (area_m2 > 0.0F)
                lamps.push_back({light, normal * (1.0F / area_m2), area_m2, static_cast<int>(i)});
        }
        lamps_ = Array<Lamp>(memory_.of(Effect::area_light), lamps.size());
        if (!lamps.empty()) backend_.upload(lamps_, view_of(std::as_const(lamps)));
        samples_.lamps = std::as_const(lamps_).view();
        samples_.area_samples = settings_.lighting.area_samples;
    }

    void run_shade(QueueSize queue, View<const PackedPixel> pixels, const FrameEyes& eyes) {
        const auto run = [&]<bool kTextures, bool kOcclusion, bool kLight>() {
            using Kernel = ShadeSurface<kTextures, kOcclusion, kLight>;
            const auto of_eye = [&](const EyeView& eye) {
                return Kernel{
                    backend_.view(),
                    EyeRays(eye),
                    pixels,
                    std::as_const(hits_).view(),
                    slots(),
                    surfaces(),
                    std::log2((eye.tan_left + eye.tan_right) / static_cast<float>(eye.width_px))};
            };
            backend_.launch(
                "shade_surface", queue,
                EyeOfPixel<Kernel>{{of_eye(eyes.view[0]), of_eye(eyes.view[1])}, pixels.data});
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

    void run_secondary(QueueSize surfaces_queue) {
        const double radius_m = settings_.lighting.ao_radius_m;
        const auto run = [&]<bool kArea, bool kOcclusion>() {
            backend_.visible(
                kSecondaryPass, surfaces_queue, samples_.count(),
                SecondaryRays<kArea, kOcclusion>{
                    surfaces(), samples_, std::as_const(patterns_).view(), lamp_points_.data(),
                    directions_.data(), radius_m > 0.0 ? static_cast<float>(radius_m) : 1.0e30F},
                AddSecondary<kArea, kOcclusion>{surfaces(), samples_});
        };
        const bool area = on(Effect::area_light);
        if (on(Effect::ambient_occlusion))
            return area ? run.template operator()<true, true>()
                        : run.template operator()<false, true>();
        return area ? run.template operator()<true, false>()
                    : run.template operator()<false, false>();
    }

    Backend& backend_;
    const Scene& scene_;
    const RenderSettings& settings_;
    const EffectPlan& plan_;
    EffectMemory& memory_;       ///< where the backend's kernels run
    EffectMemory table_memory_;  ///< of the tables on the host
    LightTables tables_;
    Array<float> lamp_points_;
    Array<float> directions_;
    Array<Lamp> lamps_;
    SecondarySamples samples_;
    Array<NumericCounts> numerics_;
    Array<Hit> hits_;
    Array<std::uint32_t> slots_;
    Array<int> patterns_;
    Array<float> rows_;
};

}  // namespace foverig
