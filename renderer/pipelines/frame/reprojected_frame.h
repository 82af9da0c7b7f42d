#pragma once
// The `reprojected` pipeline where a pass takes the whole frame at once, both eyes: what
// reprojected.h does tile by tile, with the same kernels. `Backend`: see frame_shading.h.
#include <memory>
#include <vector>

#include "renderer/foveation/foveal_function.h"
#include "renderer/image.h"
#include "renderer/kernels/cache_update.h"
#include "renderer/kernels/post_process.h"
#include "renderer/kernels/select_pixels.h"
#include "renderer/pipelines/frame/eye_images.h"
#include "renderer/pipelines/frame/footprint_taps.h"
#include "renderer/pipelines/frame/frame_mesh.h"
#include "renderer/pipelines/frame/frame_shading.h"

namespace foverig {

template <class Backend>
class ReprojectedFrame {
    template <class T>
    using Array = typename Backend::template Array<T>;
    using Eye = EyeImages<Backend::template Array>;

  public:
    /// Borrows all; `backend` holds `scene` at the time of every frame.
    ReprojectedFrame(Backend& backend, const Scene& scene, const RenderSettings& settings,
                     const EffectPlan& plan, EffectMemory& memory)
        : backend_(backend),
          settings_(settings),
          plan_(plan),
          memory_(memory),
          foveal_(settings.foveation.r0_deg, settings.foveation.r1_deg, settings.foveation.p_min),
          shading_(backend, scene, settings, plan, memory) {
        require_known_taps(settings.reprojection.footprint_samples);
        const std::size_t floats = tap_floats(settings.reprojection.footprint_samples);
        host_taps_.resize(floats);
        taps_ = Array<float>(memory.of(Effect::reprojection), floats);
    }

    /// Queues the passes of one frame; image() waits for them.
    void render(const std::vector<EyeInput>& eyes, std::uint32_t frame) {
        const bool as_before = prepare(eyes);
        const std::uint32_t frame_seed = hash32(settings_.seed, frame);
        draw_taps(view_of(host_taps_), settings_.reprojection.footprint_sigma, frame_seed);
        backend_.upload(taps_, view_of(std::as_const(host_taps_)));
        shading_.draw_samples(frame);
        backend_.frame(as_before, [&] { passes(eyes, frame, frame_seed); });
        for (const auto& eye : eyes_) eye->has_history = true;
    }

    /// Of one eye, row by row from the top; w is the samples it is worth.
    View<const Half4> image(int eye) const { return of(eye).image(); }
    FrameShading<Backend>& shading() { return shading_; }
    const FrameShading<Backend>& shading() const { return shading_; }

    Mask sampling_mask(int eye) const {
        const TileGrid& grid = of(eye).grid;
        const auto n = static_cast<std::size_t>(flags_in_eye());
        const auto flags = backend_.download(
            View<const std::uint8_t>{flags_.data() + static_cast<std::size_t>(eye) * n, n});
        return mask_of(grid, [&](int x, int y) {
            const int tile = y / kTile * grid.columns() + x / kTile;
            return flags[static_cast<std::size_t>(tile * kTilePixels + y % kTile * kTile +
                                                  x % kTile)] != 0;
        });
    }
    Mask resampling_mask(int eye) const {
        const Eye& e = of(eye);
        const auto marks = backend_.download(e.coarse_marks());
        const EyeAxis columns(e.coarse_grid.width_px, e.grid.width_px);
        const EyeAxis rows(e.coarse_grid.height_px, e.grid.height_px);
        return mask_of(e.grid, [&](int x, int y) {
            const int cell = rows.cell_of[static_cast<std::size_t>(y)] * e.coarse_grid.width_px +
                             columns.cell_of[static_cast<std::size_t>(x)];
            return marks[static_cast<std::size_t>(cell)] != 0;
        });
    }

  private:
    bool on(Effect effect) const { return plan_.on(effect); }
    const Eye& of(int eye) const { return *eyes_.at(static_cast<std::size_t>(eye)); }
    int eye_count() const { return static_cast<int>(eyes_.size()); }
    int flags_in_eye() const { return eyes_[0]->grid.count() * kTilePixels; }

    template <class Marked>
    static Mask mask_of(const TileGrid& grid, const Marked& marked) {
        Mask mask{grid.width_px, grid.height_px, {}};
        for (int y = 0; y < grid.height_px; ++y)
            for (int x = 0; x < grid.width_px; ++x) mask.pixels.push_back(marked(x, y) ? 1 : 0);
        return mask;
    }

    /// make(eye, index) for both eyes; the first stands in for a second that is not there.
    template <class Make>
    auto each_eye(int each, const Make& make) {
        using Kernel = decltype(make(*eyes_[0], std::size_t{0}));
        const std::size_t last = eyes_.size() - 1;
        return EachEye<Kernel>{{make(*eyes_[0], 0), make(*eyes_[last], last)}, each};
    }
    template <class Make>
    auto eye_of_sample(const Make& make) {
        using Kernel = decltype(make(*eyes_[0], std::size_t{0}));
        const std::size_t last = eyes_.size() - 1;
        return EyeOfPixel<Kernel>{{make(*eyes_[0], 0), make(*eyes_[last], last)},
                                  sample_pixels_.data()};
    }
    template <class Make>
    void launch_each(const char* name, int each, const Make& make) {
        backend_.launch(name, {each * eye_count()}, each_eye(each, make));
    }
    /// make(eye) -> kernel of rows.
    template <class Make>
    void launch_rows(const char* name, int rows, int columns, const Make& make) {
        using Kernel = decltype(make(*eyes_[0]));
        launch_each(name, RowSpans<Kernel>::count(rows, columns), [&](Eye& eye, std::size_t) {
            return RowSpans<Kernel>{make(eye), columns};
        });
    }
    /// make(eye, raster of its first tile) -> kernel of the first tile.
    template <class Make>
    void launch_tiles(const char* name, const TileGrid& grid, const Make& make) {
        using Kernel = decltype(make(*eyes_[0], std::size_t{0}));
        launch_each(name, TileSpans<Kernel>::count(grid), [&](Eye& eye, std::size_t index) {
            return TileSpans<Kernel>{make(eye, index), grid};
        });
    }

    /// Returns whether arrays and passes are those of the frame before.
    bool prepare(const std::vector<EyeInput>& inputs) {
        if (eyes_.size() == inputs.size() && eyes_[0]->fits(inputs[0].view)) {
            for (std::size_t i = 0; i < inputs.size(); ++i) eyes_[i]->turn(inputs[i].view);
            return std::exchange(settled_, true);
        }
        eyes_.clear();
        for (const EyeInput& input : inputs)
            eyes_.push_back(std::make_unique<Eye>(
                memory_, plan_, settings_.reprojection, input.view,
                [&](auto& array, auto from) { backend_.upload(array, from); }));
        allocate();
        settled_ = false;
        return false;
    }

    void allocate() {
        const std::size_t eyes = eyes_.size();
        const std::size_t capacity = eyes * static_cast<std::size_t>(flags_in_eye());
        MemoryCount& memory = memory_.of(Effect::reprojection);
        mesh_.allocate(memory, eye_count(), eyes_[0]->grid, eyes_[0]->coarse_grid);
        flags_ = {memory, capacity};
        sample_pixels_ = {memory, capacity};
        sample_flags_ = {memory, capacity};
        sample_colour_ = {memory, capacity};
        sample_light_ = {memory_.of(Effect::light_buffer),
                         on(Effect::light_buffer) ? 3 * capacity : 0};
        shading_.reserve(capacity);
    }

    Samples samples() {
        Samples s{sample_pixels_.data(),
                  sample_flags_.data(),
                  sample_colour_.data(),
                  nullptr,
                  nullptr,
                  nullptr};
        if (!sample_light_.empty()) {
            s.base = sample_light_.data();
            s.diffuse = s.base + sample_flags_.size();
            s.light = s.diffuse + sample_flags_.size();
        }
        return s;
    }

    void passes(const std::vector<EyeInput>& inputs, std::uint32_t frame,
                std::uint32_t frame_seed) {
        const bool history = eyes_[0]->has_history;
        if (history) find_resampling();
        const QueueSize queue = queue_samples(inputs, frame_seed);
        trace(queue, inputs, frame);
        if (history)
            reproject();
        else
            mesh_.draw_nothing(backend_, "reproject_raster", eyes_[0]->grid,
                               rasters([](const Eye& eye) { return eye.image_raster(); }));
        combine(queue, frame);
        if (on(Effect::post_process) && history) post_process(queue, frame_seed);
    }

    /// raster(eye) of each.
    template <class Raster>
    typename FrameMesh<Backend>::Frames rasters(const Raster& raster) const {
        return {raster(*eyes_.front()), raster(*eyes_.back())};
    }

    void find_resampling() {
        const TileGrid& coarse = eyes_[0]->coarse_grid;
        const int columns = coarse.width_px;
        const int rows = coarse.height_px;
        launch_rows("reproject_vertices", rows, columns,
                    [](Eye& eye) { return eye.reproject_vertices(); });
        launch_rows("measure_facing", rows - 1, columns - 1,
                    [](Eye& eye) { return eye.measure_facing(); });
        mesh_.draw(backend_, "reproject_coarse", coarse,
                   rasters([](const Eye& eye) { return eye.coarse_raster(); }));
        launch_tiles("reproject_coarse", coarse,
                     [&](Eye& eye, std::size_t i) { return eye.resolve_coarse(mesh_.tiles(i)); });
        launch_rows("mark_resampling", rows, columns,
                    [&](Eye& eye) { return eye.mark_resampling(settings_.reprojection); });
    }

    QueueSize queue_samples(const std::vector<EyeInput>& inputs, std::uint32_t frame_seed) {
        const auto flags = [&](std::size_t eye) {
            return flags_.data() + eye * static_cast<std::size_t>(flags_in_eye());
        };
        launch_tiles("select_pixels", eyes_[0]->grid, [&](Eye& eye, std::size_t i) {
            return SelectPixels{foveal_,
                                EyeRays(eye.view),
                                glm::normalize(eye.view.world_from_eye * inputs[i].gaze),
                                frame_seed,
                                eye.resampled(),
                                eye.support_column.data(),
                                eye.support_row.data(),
                                TileZone::falloff,
                                0,
                                0,
                                0,
                                flags(i)};
        });
        const int each = flags_in_eye();
        return backend_.number(
            "queue_pixels", {each * eye_count()},
            each_eye(each, [&](Eye&, std::size_t i) { return IsChosen{flags(i)}; }),
            each_eye(each, [&](Eye& eye, std::size_t i) {
                return QueueSample{flags(i), eye.grid, sample_pixels_.data(), sample_flags_.data(),
                                   static_cast<std::uint32_t>(i)};
            }));
    }

    void trace(QueueSize queue, const std::vector<EyeInput>& inputs, std::uint32_t frame) {
        FrameEyes views;
        views.count = eye_count();
        for (std::size_t i = 0; i < kMostEyes; ++i)
            views.view[i] = inputs[i < inputs.size() ? i : 0].view;
        shading_.shade(queue, std::as_const(sample_pixels_).view(), views,
                       on(Effect::oversampling) ? pixel_jitter_px(frame) : vec2(0.0F));
        const auto run = [&]<bool kOcclusion, bool kLight>() {
            backend_.launch("store_samples", queue, eye_of_sample([&](Eye& eye, std::size_t) {
                                return StoreSamples<kOcclusion, kLight>{shading_.surfaces(),
                                                                        shading_.slots(),
                                                                        samples(),
                                                                        eye.support(),
                                                                        eye.support_column.data(),
                                                                        eye.support_row.data(),
                                                                        shading_.scene().ambient,
                                                                        shading_.scene().background,
                                                                        shading_.numerics()};
                            }));
        };
        as_planned(run);
    }

    /// run<kOcclusion, kLightBuffer>().
    template <class Run>
    void as_planned(const Run& run) {
        if (on(Effect::ambient_occlusion)) return run.template operator()<true, true>();
        if (on(Effect::light_buffer)) return run.template operator()<false, true>();
        run.template operator()<false, false>();
    }

    void reproject() {
        const TileGrid& grid = eyes_[0]->grid;
        mesh_.draw(backend_, "reproject_raster", grid,
                   rasters([](const Eye& eye) { return eye.image_raster(); }));
        const auto run = [&]<int kTaps, bool kLight>() {
            launch_tiles("reproject", grid, [&](Eye& eye, std::size_t i) {
                return ReprojectPixels<kTaps, kLight>{
                    mesh_.tiles(i), {taps_.data()}, eye.last(), eye.current(), 0, 0, 0,
                    grid.width_px,  grid.height_px};
            });
        };
        const auto run_lit = [&]<bool kLight>() {
            switch (settings_.reprojection.footprint_samples) {
                case 1:
                    return run.template operator()<1, kLight>();
                case 2:
                    return run.template operator()<2, kLight>();
                case 8:
                    return run.template operator()<8, kLight>();
                default:
                    return run.template operator()<4, kLight>();
            }
        };
        if (on(Effect::light_buffer)) return run_lit.template operator()<true>();
        run_lit.template operator()<false>();
    }

    void combine(QueueSize queue, std::uint32_t frame) {
        const TileGrid& grid = eyes_[0]->grid;
        const ReprojectionSettings& s = settings_.reprojection;
        const auto merge = [&]<bool kLight>() {
            launch_tiles("merge", grid, [&](Eye& eye, std::size_t i) {
                return MergeSupport<kLight>{
                    mesh_.tiles(i), eye.support_lookup(), eye.current(), 0, 0, 0, grid.width_px,
                    frame};
            });
        };
        if (on(Effect::light_buffer))
            merge.template operator()<true>();
        else
            merge.template operator()<false>();
        const auto update = [&]<bool kOcclusion, bool kLight, bool kOversampling>() {
            using Kernel = CacheUpdate<kOcclusion, kLight, kOversampling>;
            backend_.launch(
                "cache_update", queue, eye_of_sample([&](Eye& eye, std::size_t i) {
                    return InTileOfSample<Kernel>{
                        {mesh_.tiles(i), samples(), eye.current(),
                         SmallestWeight(s.k_min, s.k_max, s.t_max),
                         SmallestWeight(s.k_min_light, s.k_max, s.t_max), shading_.scene().ambient,
                         static_cast<float>(s.epsilon_cache), frame, 0, 0, grid.width_px},
                        grid};
                }));
        };
        as_planned([&]<bool kOcclusion, bool kLight>() {
            if (on(Effect::oversampling))
                return update.template operator()<kOcclusion, kLight, true>();
            update.template operator()<kOcclusion, kLight, false>();
        });
    }

    void post_process(QueueSize queue, std::uint32_t frame_seed) {
        const ReprojectionSettings& s = settings_.reprojection;
        const LightingSettings& lighting = settings_.lighting;
        const auto run = [&]<bool kOcclusion>() {
            backend_.launch("post_process", queue, eye_of_sample([&](Eye& eye, std::size_t) {
                                return PostProcess<kOcclusion>{samples(),
                                                               eye.current(),
                                                               eye.resampled(),
                                                               eye.coarse().inverse_depth,
                                                               static_cast<float>(s.epsilon_cache),
                                                               light_noise(lighting.area_samples),
                                                               light_noise(lighting.ao_samples),
                                                               shading_.scene().ambient,
                                                               s.post_samples,
                                                               s.post_search_px,
                                                               frame_seed,
                                                               eye.grid.width_px,
                                                               eye.grid.height_px};
                            }));
        };
        if (on(Effect::ambient_occlusion)) return run.template operator()<true>();
        run.template operator()<false>();
    }

    Backend& backend_;
    const RenderSettings& settings_;
    const EffectPlan& plan_;
    EffectMemory& memory_;
    FovealFunction foveal_;
    FrameShading<Backend> shading_;
    std::vector<float> host_taps_;
    Array<float> taps_;
    std::vector<std::unique_ptr<Eye>> eyes_;
    bool settled_ = false;  ///< the last frame ran every pass that this one does
    FrameMesh<Backend> mesh_;
    Array<std::uint8_t> flags_;
    Array<PackedPixel> sample_pixels_;
    Array<std::uint8_t> sample_flags_;
    Array<Half4> sample_colour_;
    Array<Half4> sample_light_;  ///< base, diffuse, light one after the other
};

}  // namespace foverig
