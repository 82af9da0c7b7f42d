#pragma once
#include "renderer/foveation/foveal_function.h"
#include "renderer/pipelines/core.h"
#include "renderer/pipelines/reprojected_eye.h"

namespace foverig {

/// Weier et al. 2016: foveated sampling, reprojection through a coarse depth mesh, resampling where
/// that fails, temporal cache, merge with the support image, post-process. docs/reprojected.md ties
/// formula to file.
class ReprojectedRenderer final : public Renderer {
  public:
    ReprojectedRenderer(std::shared_ptr<const Scene> scene, const RenderSettings& settings);

    FrameStats render(const FrameInput& input) override;
    bool tune(const RenderSettings& settings) override;
    const EffectPlan& plan() const override { return core_.plan(); }
    std::string backend_name() const override { return core_.backend_name(); }
    std::uint64_t backend_bytes() const override { return core_.bytes(); }
    Image image(int eye) const override;
    View<const Half4> pixels(int eye) const override;
    Mask sampling_mask(int eye) const override;
    Mask resampling_mask(int eye) const override;

  private:
    /// What one thread needs besides the ray queues.
    struct Scratch {
        Scratch(MemoryCount& memory, std::size_t blocks);
        RasterTile raster();

        Buffer<float> raster_rows;
        Buffer<std::uint8_t> block_flags;
        Buffer<std::uint8_t> pixel_flags;
        Buffer<std::uint8_t> sparse;
    };

    int tap_count() const { return core_.settings().reprojection.footprint_samples; }
    void prepare_eyes(const FrameInput& input);
    void reproject_mesh(ReprojectedEye& eye);
    void find_resampling(ReprojectedEye& eye);
    void trace_tiles(ReprojectedEye& eye, const EyeInput& input, std::uint32_t frame);
    int queue_pixels(Lane& lane, int thread, ReprojectedEye& eye, const EyeInput& input, int tile,
                     std::uint32_t frame_seed);
    void store_samples(Lane& lane, TileScratch& scratch, ReprojectedEye& eye, int tile, int n,
                       const ShadingFrame& frame);
    void raster_tile(ReprojectedEye& eye, Scratch& scratch, const RasterFrame& frame,
                     const TileRange& range);
    void combine_tiles(ReprojectedEye& eye, std::uint32_t frame);
    template <bool kOcclusion, bool kLightBuffer>
    void combine_tile(Lane& lane, ReprojectedEye& eye, Scratch& scratch, int tile,
                      std::uint32_t frame);
    void post_process(ReprojectedEye& eye, std::uint32_t frame_seed);

    PipelineCore core_;
    FovealFunction foveal_;
    Buffer<float> taps_;
    std::vector<std::unique_ptr<ReprojectedEye>> eyes_;
    std::vector<Scratch> scratches_;
};

}  // namespace foverig
