#include "renderer/pipelines/core.h"

#include <algorithm>
#include <chrono>
#include <tuple>

namespace foverig {
namespace {

std::int64_t now_ns() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

embree::EmbreeSettings embree_settings(const EffectPlan& plan, const RenderSettings& settings) {
    embree::EmbreeSettings s;
    s.alpha_test = plan.on(Effect::alpha_mask);
    s.textures = plan.on(Effect::textures);
    s.motion = plan.on(Effect::moving_geometry);
    s.robust = settings.robust_tracing;
    s.threads = settings.threads;
    return s;
}

constexpr const char* kHostBvh = "host-bvh";

Tracer tracer_of(const RenderSettings& settings) {
    return settings.backend == kHostBvh ? Tracer::host_bvh : Tracer::embree;
}

/// Whether the same tracer and the same images serve both.
bool same_apparatus(const RenderSettings& a, const RenderSettings& b) {
    const auto parts = [](const RenderSettings& s) {
        return std::tie(s.pipeline, s.backend, s.threads, s.robust_tracing,
                        s.reprojection.support_width_px, s.reprojection.support_height_px,
                        s.reprojection.footprint_samples);
    };
    return parts(a) == parts(b);
}

bool same_samples(const LightingSettings& a, const LightingSettings& b) {
    return a.area_samples == b.area_samples && a.ao_samples == b.ao_samples;
}

}  // namespace

PipelineCore::PipelineCore(std::shared_ptr<const Scene> scene, const RenderSettings& settings)
    : scene_(std::move(scene)),
      settings_(settings),
      plan_(*scene_, settings),
      backend_(*scene_, embree_settings(plan_, settings), tracer_of(settings)),
      tables_(memory_, plan_, *scene_, settings.lighting) {
    for (int i = 0; i < backend_.threads(); ++i) scratches_.emplace_back(memory_, plan_);
}

bool PipelineCore::tune(const RenderSettings& settings) {
    const EffectPlan plan(*scene_, settings);
    if (!same_apparatus(settings_, settings) || !plan_.same_effects(plan)) return false;
    if (!same_samples(settings_.lighting, settings.lighting))
        tables_ = LightTables(memory_, plan_, *scene_, settings.lighting);
    plan_.take_reasons(plan);
    settings_ = settings;
    return true;
}

void PipelineCore::begin_frame(const FrameInput& input) {
    frame_start_ns_ = now_ns();
    if (plan_.on(Effect::moving_geometry)) {
        backend_.set_time(input.time_s);
        backend_.add_pass("move_geometry", now_ns() - frame_start_ns_);
    }
    if (plan_.on(Effect::light_buffer)) tables_.update(settings_.seed, input.frame);
}

FrameStats PipelineCore::end_frame(std::uint64_t all_pixels) {
    FrameStats stats;
    stats.render_ms = static_cast<double>(now_ns() - frame_start_ns_) * 1e-6;
    for (TileScratch& s : scratches_) {
        stats.rays.primary += s.rays.primary;
        stats.rays.shadow += s.rays.shadow;
        stats.rays.ao += s.rays.ao;
        stats.rays.reflection += s.rays.reflection;
        stats.rays.probe += s.rays.probe;
        stats.sampled_pixels += s.sampled_pixels;
        stats.numerics.nan += s.numerics.nan;
        stats.numerics.inf += s.numerics.inf;
        stats.numerics.clamped += s.numerics.clamped;
        s.rays = {};
        s.numerics = {};
        s.sampled_pixels = 0;
    }
    stats.all_pixels = all_pixels;
    const PassTable passes = backend_.take_passes();
    for (const PassTable::Entry& e : passes.entries())
        stats.passes.push_back(
            {std::string(e.name), static_cast<double>(e.ns) * 1e-6 / backend_.threads()});
    ++frames_;
    plan_.record_frame(stats.passes, frames_);
    record_bytes();
    return stats;
}

void PipelineCore::record_bytes() {
    for (std::size_t i = 0; i < plan_.effects().size(); ++i) {
        const auto effect = static_cast<Effect>(i);
        plan_.record_bytes(effect, memory_.bytes(effect));
    }
    const SceneBytes scene = backend_.bytes();
    plan_.record_bytes(Effect::textures, memory_.bytes(Effect::textures) + scene.textures);
    plan_.record_bytes(Effect::moving_geometry,
                       memory_.bytes(Effect::moving_geometry) + scene.motion);
}

std::string PipelineCore::backend_name() const {
    return backend_.tracer() == Tracer::host_bvh ? kHostBvh : "embree";
}

ShadingFrame PipelineCore::shading_frame(const EyeView& eye) const {
    return make_shading_frame(backend_.view(), plan_, tables_, eye, settings_.lighting);
}

}  // namespace foverig
