#pragma once
#include "renderer/buffer.h"
#include "renderer/kernels/samples.h"
#include "renderer/pipelines/frame/eye_images.h"

namespace foverig {

/// One eye of the `reprojected` pipeline on the CPU: its images, and what its tiles need besides.
class ReprojectedEye : public EyeImages<Buffer> {
  public:
    ReprojectedEye(EffectMemory& memory, const EffectPlan& plan,
                   const ReprojectionSettings& settings, const EyeView& first_view);

    CellBlocks blocks();
    Samples samples(int tile);

    Buffer<int> sample_counts;  ///< by tile

  private:
    Buffer<std::uint8_t> block_boxes_;
    Buffer<PackedPixel> sample_pixels_;
    Buffer<std::uint8_t> sample_flags_;
    Buffer<Half4> sample_colour_;
    Buffer<Half4> sample_light_;  ///< base, diffuse, light one after the other
};

}  // namespace foverig
