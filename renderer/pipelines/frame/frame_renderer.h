#pragma once
// A Renderer whose passes take whole frames: on the GPU, and on its twin on the host.
#include <chrono>
#include <stdexcept>
#include <type_traits>

#include "renderer/backends/host_bvh/host_bvh_scene.h"
#include "renderer/pass_table.h"
#include "renderer/pipelines/frame/eye_image.h"
#include "renderer/pipelines/frame/full_frame.h"
#include "renderer/pipelines/frame/reprojected_frame.h"
#include "renderer/renderer.h"

namespace foverig {

/// `Pipeline` is FullFrame or ReprojectedFrame. Throws what the backend throws.
template <class Backend, template <class> class Pipeline>
class FrameRenderer final : public Renderer {
  public:
    /// `more` goes to the backend after the scene.
    template <class... More>
    FrameRenderer(std::shared_ptr<const Scene> scene, const RenderSettings& settings,
                  BuildBinary build_still, const More&... more)
        : scene_(std::move(scene)),
          settings_(settings),
          plan_(*scene_, settings),
          posed_(*scene_, {plan_.on(Effect::alpha_mask),
                           {plan_.on(Effect::textures), plan_.on(Effect::moving_geometry)},
                           std::move(build_still)}),
          backend_(posed_, more...),
          pipeline_(backend_, *scene_, settings_, plan_, memory_) {}
    FrameRenderer(const FrameRenderer&) = delete;
    FrameRenderer& operator=(const FrameRenderer&) = delete;
    ~FrameRenderer() override = default;

    FrameStats render(const FrameInput& input) override {
        require_one_size(input);
        backend_.enter();
        const auto start = std::chrono::steady_clock::now();
        if (plan_.on(Effect::moving_geometry)) backend_.set_time(posed_, input.time_s);
        pipeline_.render(input.eyes, input.frame);
        const PassTable passes = backend_.take_passes();
        FrameStats stats = stats_of(input, passes);
        stats.numerics = pipeline_.shading().take_numerics();
        stats.render_ms =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                .count();
        size_ = {input.eyes[0].view.width_px, input.eyes[0].view.height_px};
        ++frames_;
        plan_.record_frame(stats.passes, frames_);
        record_bytes();
        return stats;
    }

    const EffectPlan& plan() const override { return plan_; }
    std::string backend_name() const override { return Backend::kName; }
    std::uint64_t backend_bytes() const override {
        return memory_.bytes() + backend_.bytes() + posed_.bytes().total();
    }
    Image image(int eye) const override { return image_of(pixels(eye), size_); }
    View<const Half4> pixels(int eye) const override {
        backend_.enter();
        return backend_.on_host(pipeline_.image(eye), eye);
    }
    bool copy_to_texture(int eye, unsigned int gl_texture) const override {
        backend_.enter();
        return backend_.copy_to_texture(pipeline_.image(eye), size_.width_px, size_.height_px, eye,
                                        gl_texture);
    }
    Mask sampling_mask(int eye) const override {
        backend_.enter();
        if constexpr (kReprojects) return pipeline_.sampling_mask(eye);
        return {};
    }
    Mask resampling_mask(int eye) const override {
        backend_.enter();
        if constexpr (kReprojects) return pipeline_.resampling_mask(eye);
        return {};
    }

  private:
    static constexpr bool kReprojects =
        std::is_same_v<Pipeline<Backend>, ReprojectedFrame<Backend>>;

    static void require_one_size(const FrameInput& input) {
        if (input.eyes.empty() || input.eyes.size() > kMostEyes)
            throw std::invalid_argument("a frame has " + std::to_string(input.eyes.size()) +
                                        " eyes; one or two can be rendered");
        const EyeView& first = input.eyes.front().view;
        const EyeView& last = input.eyes.back().view;
        if (first.width_px != last.width_px || first.height_px != last.height_px)
            throw std::invalid_argument(
                "the eyes of a frame differ in size; on this backend they are rendered together "
                "and need one");
    }

    FrameStats stats_of(const FrameInput& input, const PassTable& passes) {
        FrameStats stats;
        for (const EyeInput& eye : input.eyes) stats.all_pixels += pixel_count(eye.view);
        std::uint64_t secondary = 0;
        std::int64_t secondary_ns = 0;
        for (const PassTable::Entry& e : passes.entries()) {
            if (e.name == kPrimaryPass) stats.rays.primary += e.rays;
            if (e.name == kSecondaryPass) {
                secondary += e.rays;
                secondary_ns += e.ns;
            } else {
                stats.passes.push_back({std::string(e.name), static_cast<double>(e.ns) * 1e-6});
            }
        }
        stats.sampled_pixels = stats.rays.primary;
        // Every occlusion ray is traced: what is left are shadow rays.
        const auto surfaces = static_cast<std::uint64_t>(backend_.take_numbers().back());
        stats.rays.ao =
            surfaces * static_cast<std::uint64_t>(pipeline_.shading().samples().ao_samples);
        stats.rays.shadow = secondary - stats.rays.ao;
        share_out(secondary_ns, stats);
        return stats;
    }

    /// One pass traces the rays of all lights: its time is theirs by their rays, and among shadow
    /// rays by how many could be asked.
    void share_out(std::int64_t ns, FrameStats& stats) const {
        const SecondarySamples& samples = pipeline_.shading().samples();
        const double all =
            static_cast<double>(std::max<std::uint64_t>(1, stats.rays.ao + stats.rays.shadow));
        const double shadow = static_cast<double>(stats.rays.shadow) / all;
        const double points = samples.points_end();
        const double lamps = samples.lamps_end() - samples.points_end();
        const double ms = static_cast<double>(ns) * 1e-6;
        if (points > 0.0)
            stats.passes.push_back({"shadow_point", ms * shadow * points / (points + lamps)});
        if (lamps > 0.0)
            stats.passes.push_back({"shadow_area", ms * shadow * lamps / (points + lamps)});
        if (samples.ao_samples > 0)
            stats.passes.push_back({"ambient_occlusion", ms * (1.0 - shadow)});
    }

    void record_bytes() {
        for (std::size_t i = 0; i < plan_.effects().size(); ++i) {
            const auto effect = static_cast<Effect>(i);
            plan_.record_bytes(effect, memory_.bytes(effect));
        }
        const SceneBytes scene = posed_.bytes();
        plan_.record_bytes(Effect::textures, memory_.bytes(Effect::textures) + scene.textures);
        plan_.record_bytes(Effect::moving_geometry,
                           memory_.bytes(Effect::moving_geometry) + scene.motion);
    }

    std::shared_ptr<const Scene> scene_;
    RenderSettings settings_;
    EffectPlan plan_;
    EffectMemory memory_;
    host_bvh::HostBvhScene posed_;
    mutable Backend backend_;
    Pipeline<Backend> pipeline_;
    TileGrid size_;
    std::uint64_t frames_ = 0;
};

}  // namespace foverig
