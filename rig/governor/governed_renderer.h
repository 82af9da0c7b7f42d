#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "renderer/renderer.h"
#include "rig/governor/governor.h"
#include "rig/governor/ladder.h"
#include "rig/records/run_record.h"

namespace foverig::governor {

/// A renderer that a governor gives one of a ladder's settings each frame. Settings that it cannot
/// take while it runs (another support resolution, another effect) have one of their own, which
/// comes back with the history that it had.
class GovernedRenderer : public Renderer {
  public:
    using Open = std::function<std::unique_ptr<Renderer>(const RenderSettings&)>;

    GovernedRenderer(Ladder ladder, const Limits& limits, const Open& open);

    FrameStats render(const FrameInput& input) override;
    /// Tells the governor, who chooses for the next frame.
    void frame_took(double ms) { governor_.frame_took(ms); }
    /// At a fixed cost the dearest setting costs that, the others in proportion to the ladder.
    double fixed_ms(double dearest_ms) const;

    /// What was chosen for each frame, in their order.
    const std::vector<std::uint32_t>& chosen() const { return chosen_; }
    GovernorRecord record() const;

    const EffectPlan& plan() const override { return now().plan(); }
    std::string backend_name() const override { return now().backend_name(); }
    /// Of all renderers: they are all there.
    std::uint64_t backend_bytes() const override;
    Image image(int eye) const override { return now().image(eye); }
    View<const Half4> pixels(int eye) const override { return now().pixels(eye); }
    bool copy_to_texture(int eye, unsigned int gl_texture) const override {
        return now().copy_to_texture(eye, gl_texture);
    }
    Mask sampling_mask(int eye) const override { return now().sampling_mask(eye); }
    Mask resampling_mask(int eye) const override { return now().resampling_mask(eye); }
    double estimated_error() const override { return now().estimated_error(); }

  private:
    struct Held {
        std::unique_ptr<Renderer> renderer;
        std::size_t setting = 0;  ///< that it has
    };

    const Renderer& now() const { return *held_[held_by_[shown_]].renderer; }
    void hold(std::size_t setting, const Open& open);

    Ladder ladder_;
    Limits limits_;
    Governor governor_;
    std::vector<Held> held_;
    std::vector<std::size_t> held_by_;  ///< of each setting, which of held_
    std::size_t shown_ = 0;             ///< whose images there are: the last frame's
    std::vector<std::uint32_t> chosen_;
};

/// What a scenario's governor is to keep to.
Limits limits_of(const Scenario& scenario);

}  // namespace foverig::governor
