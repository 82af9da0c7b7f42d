#pragma once
// A renderer that traces nothing: what the frame loop does must not depend on what a frame shows.
#include <array>
#include <vector>

#include "renderer/renderer.h"

namespace foverig {

class FakeRenderer final : public Renderer {
  public:
    FrameStats render(const FrameInput& input) override {
        inputs.push_back(input);
        FrameStats stats;
        // Differs from run to run, as wall times do.
        stats.render_ms = static_cast<double>(reinterpret_cast<std::uintptr_t>(this) % 1000);
        stats.passes = {{"trace_primary", stats.render_ms / 2}};
        stats.rays.primary = 100 + input.frame;
        stats.sampled_pixels = 100;
        stats.all_pixels = 400;
        return stats;
    }
    const EffectPlan& plan() const override { return plan_; }
    std::string backend_name() const override { return "fake"; }
    std::uint64_t backend_bytes() const override { return 1000; }
    Image image(int eye) const override {
        const float grey = 0.25F * static_cast<float>(eye + 1);
        return {2, 2, std::vector<vec3>(4, vec3(grey))};
    }
    View<const Half4> pixels(int) const override { return {pixels_.data(), pixels_.size()}; }
    Mask sampling_mask(int) const override { return {2, 2, {1, 0, 0, 1}}; }
    Mask resampling_mask(int) const override { return {}; }

    std::vector<FrameInput> inputs;

  private:
    EffectPlan plan_;
    std::array<Half4, 4> pixels_{};
};

}  // namespace foverig
