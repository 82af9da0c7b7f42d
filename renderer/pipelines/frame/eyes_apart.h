#pragma once
#include <vector>

#include "renderer/renderer.h"

namespace foverig {

/// One renderer an eye, at the same time: each on a GPU of its own.
class EyesApart final : public Renderer {
  public:
    /// Two or more, alike but for where they run; a frame may have as many eyes, or fewer.
    explicit EyesApart(std::vector<std::unique_ptr<Renderer>> eyes) : eyes_(std::move(eyes)) {}

    /// Counts are sums; a pass took as long as on the slower one. Throws what any of them throws,
    /// once all have ended, and std::invalid_argument for more eyes than there are.
    FrameStats render(const FrameInput& input) override;

    /// Costs and reasons are those of the first eye.
    const EffectPlan& plan() const override { return eyes_.front()->plan(); }
    std::string backend_name() const override;
    std::uint64_t backend_bytes() const override;
    Image image(int eye) const override { return of(eye).image(0); }
    View<const Half4> pixels(int eye) const override { return of(eye).pixels(0); }
    bool copy_to_texture(int eye, unsigned int gl_texture) const override {
        return of(eye).copy_to_texture(0, gl_texture);
    }
    Mask sampling_mask(int eye) const override { return of(eye).sampling_mask(0); }
    Mask resampling_mask(int eye) const override { return of(eye).resampling_mask(0); }

  private:
    const Renderer& of(int eye) const { return *eyes_.at(static_cast<std::size_t>(eye)); }

    std::vector<std::unique_ptr<Renderer>> eyes_;
};

}  // namespace foverig
