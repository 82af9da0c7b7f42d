#pragma once
// The ray passes of one frame outside their pipeline: the same queue, shading and scene handle, so
// that bare Embree can be given the very same rays and the two can take turns.
#include <vector>

#include "bench/anchor_rays.h"
#include "bench/cases.h"
#include "renderer/pipelines/core.h"

namespace foverig::bench {

/// Which pixels of a frame are queued: all of every n-th tile, or those of a foveated frame.
struct Selection {
    int tile_stride = 1;
    Mask mask;            ///< empty: all
    float r0_deg = 0.0F;  ///< of a mask: further out neighbours are not traced
};

/// Queues of the tiles of a frame, in the pipelines' order.
std::vector<PixelQueue> queues_of(const EyeInput& eye, const Selection& selection);

/// What `full` and `reprojected` both do with a tile's queue (shade_tile.h), for given queues.
class TracedFrame {
  public:
    TracedFrame(PipelineCore& core, const FrameInput& input, const Selection& selection);

    /// Runs all ray passes on all tiles; pass times and ray counts as in a frame.
    FrameStats trace();

    const std::vector<PixelQueue>& queues() const { return queues_; }
    /// The visibility rays of the load's one kind of light, by tile.
    std::vector<RayList> visibility_rays();

    /// Share of primary rays whose answer differs from the anchor's by more than 1e-5 of the depth.
    double wrong_primary_share(const struct PrimaryAnchor& anchor);
    /// Visibility rays that the renderer's own packets find occluded.
    std::uint64_t occluded_by_packets();

  private:
    template <class Use>
    void for_visibility_rays(TileScratch& scratch, int surfaces, const Use& use) const;
    int shade(Lane& lane, TileScratch& scratch, int tile);

    PipelineCore& core_;
    FrameInput input_;
    ShadingFrame frame_;
    std::vector<PixelQueue> queues_;
};

}  // namespace foverig::bench
