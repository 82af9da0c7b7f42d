#pragma once
#include "renderer/half.h"
#include "renderer/pipelines/core.h"

namespace foverig {

/// The papers' control: every pixel traced, with the same shading and the same sample positions.
class FullRenderer final : public Renderer {
  public:
    FullRenderer(std::shared_ptr<const Scene> scene, const RenderSettings& settings)
        : core_(std::move(scene), settings) {}

    FrameStats render(const FrameInput& input) override;
    bool tune(const RenderSettings& settings) override { return core_.tune(settings); }
    const EffectPlan& plan() const override { return core_.plan(); }
    std::string backend_name() const override { return core_.backend_name(); }
    std::uint64_t backend_bytes() const override { return core_.bytes(); }
    Image image(int eye) const override;
    View<const Half4> pixels(int eye) const override;
    Mask sampling_mask(int) const override { return {}; }
    Mask resampling_mask(int) const override { return {}; }

  private:
    void render_tile(Lane& lane, TileScratch& scratch, const ShadingFrame& frame,
                     const TileRect& tile, View<Half4> image, int width_px);

    PipelineCore core_;
    struct Eye {
        TileGrid grid;
        Buffer<Half4> image;
    };
    std::vector<Eye> eyes_;
};

}  // namespace foverig
