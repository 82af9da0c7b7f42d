#pragma once
#include "renderer/pipelines/core.h"
#include "renderer/pipelines/reference_tile.h"

namespace foverig {

/// Ground truth: progressive path tracing. Every vertex has the direct light that `full` gives a
/// surface (point and area lights, `ambient` by its occlusion), so that with max_bounces = 0 it
/// converges to what `full` estimates, over the whole pixel; each bounce adds the light that
/// diffuse surfaces and mirrors pass on. `render` adds kSamplesPerCall samples while views and time
/// stay, and starts again when they change. Even and odd samples go to two halves with randomness
/// of their own, whose difference says how far the mean is off. At most 2^17 samples.
class ReferenceRenderer final : public Renderer {
  public:
    static constexpr int kSamplesPerCall = 8;

    ReferenceRenderer(std::shared_ptr<const Scene> scene, const RenderSettings& settings);

    FrameStats render(const FrameInput& input) override;
    const EffectPlan& plan() const override { return core_.plan(); }
    std::string backend_name() const override { return core_.backend_name(); }
    std::uint64_t backend_bytes() const override { return core_.bytes(); }
    Image image(int eye) const override;
    View<const Half4> pixels(int eye) const override;
    Mask sampling_mask(int) const override { return {}; }
    Mask resampling_mask(int) const override { return {}; }
    /// RMS over pixels, channels and eyes of half the difference of the two halves' means, over the
    /// RMS of their mean: the standard error of the image relative to its level. < 0 before both
    /// halves hold a sample.
    double estimated_error() const override { return error_; }

  private:
    struct Eye {
        TileGrid grid;
        Buffer<dvec3> halves[2];
        Buffer<dvec2> squares;  ///< by tile: of the halved difference, of the mean
        Buffer<Half4> shown;    ///< the mean, as displays want it
    };

    void start_again(const FrameInput& input);
    void add_samples(Eye& eye, const EyeView& view, int count);
    void measure(Eye& eye);
    vec3 mean(const Eye& eye, std::size_t pixel) const;
    void show(Eye& eye);
    bool done() const;

    PipelineCore core_;
    std::vector<PathScratch> scratches_;
    std::vector<Eye> eyes_;
    FrameInput shown_;  ///< what the sums are of
    int samples_ = 0;
    double error_ = -1.0;
};

}  // namespace foverig
