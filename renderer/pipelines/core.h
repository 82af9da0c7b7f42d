#pragma once
#include <memory>
#include <string>
#include <vector>

#include "renderer/backends/cpu/cpu_backend.h"
#include "renderer/effects/memory.h"
#include "renderer/pipelines/shade_tile.h"
#include "renderer/renderer.h"

namespace foverig {

/// What every pipeline on the CPU has: scene, plan, backend, light tables, a scratch a
/// thread, and the bookkeeping around a frame.
class PipelineCore {
  public:
    PipelineCore(std::shared_ptr<const Scene> scene, const RenderSettings& settings);

    /// As Renderer::tune says: light samples, thresholds, foveation and seed may change.
    bool tune(const RenderSettings& settings);

    /// Moves what moves and draws the frame's sample points.
    void begin_frame(const FrameInput& input);
    /// Collects counts and pass times since begin_frame, and hands the effects their share of
    /// time and memory.
    FrameStats end_frame(std::uint64_t all_pixels);

    ShadingFrame shading_frame(const EyeView& eye) const;
    TileScratch& scratch(int thread) { return scratches_[static_cast<std::size_t>(thread)]; }

    const RenderSettings& settings() const { return settings_; }
    const EffectPlan& plan() const { return plan_; }
    EffectPlan& plan() { return plan_; }
    CpuBackend& backend() { return backend_; }
    EffectMemory& memory() { return memory_; }
    const Scene& scene() const { return *scene_; }
    std::string backend_name() const;
    std::uint64_t bytes() const { return memory_.bytes() + backend_.bytes().total(); }

  private:
    void record_bytes();

    std::shared_ptr<const Scene> scene_;
    RenderSettings settings_;
    EffectPlan plan_;
    EffectMemory memory_;
    CpuBackend backend_;
    LightTables tables_;
    std::vector<TileScratch> scratches_;
    std::int64_t frame_start_ns_ = 0;
    std::uint64_t frames_ = 0;
};

}  // namespace foverig
