#pragma once
#include "renderer/renderer.h"

namespace foverig {

/// Renders nothing: a session with it is its inputs, and the rig's own time.
class NoRenderer final : public Renderer {
  public:
    FrameStats render(const FrameInput&) override { return {}; }
    const EffectPlan& plan() const override { return plan_; }
    std::string backend_name() const override { return "none"; }
    std::uint64_t backend_bytes() const override { return 0; }
    Image image(int) const override { return {}; }
    View<const Half4> pixels(int) const override { return {}; }
    Mask sampling_mask(int) const override { return {}; }
    Mask resampling_mask(int) const override { return {}; }

  private:
    EffectPlan plan_;
};

}  // namespace foverig
