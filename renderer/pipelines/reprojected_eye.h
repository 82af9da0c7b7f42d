#pragma once
#include <array>

#include "renderer/effects/memory.h"
#include "renderer/kernels/merge.h"
#include "renderer/kernels/resampling.h"
#include "renderer/kernels/samples.h"
#include "renderer/pipelines/tile_grid.h"
#include "renderer/renderer.h"

namespace foverig {

/// Everything one eye of the `reprojected` pipeline keeps: two generations of history and support
/// images, the depth mesh, the coarse view, and the samples of the frame. Allocated once a
/// resolution.
class ReprojectedEye {
  public:
    ReprojectedEye(EffectMemory& memory, const EffectPlan& plan,
                   const ReprojectionSettings& settings, const EyeView& first_view);

    bool fits(const EyeView& other) const {
        return grid.width_px == other.width_px && grid.height_px == other.height_px;
    }
    /// Makes the current generation the last one.
    void turn() { current_ ^= 1; }

    HistoryImages current() { return history(current_); }
    HistoryImages last() { return history(current_ ^ 1); }
    SupportImages support() { return support_images(current_); }
    SupportImages last_support() { return support_images(current_ ^ 1); }
    DepthMesh mesh() const;
    CellBlocks blocks();
    CoarseView coarse();
    CoarseLookup resampled() const;
    SupportLookup support_lookup();
    Samples samples(int tile);
    View<const Half4> image() const { return colour_[static_cast<std::size_t>(current_)].view(); }

    TileGrid grid;
    TileGrid coarse_grid;  ///< the support resolution
    EyeView view;          ///< of the current frame
    EyeView last_view;
    bool has_history = false;
    Buffer<std::int16_t> support_column;  ///< by pixel column: the support column there, or -1
    Buffer<std::int16_t> support_row;
    Buffer<std::int16_t> coarse_column;  ///< by pixel column: the coarse cell over it
    Buffer<std::int16_t> coarse_row;
    Buffer<std::int16_t> coarse_column_from_px;  ///< by cell column: its first pixel, and the end
    Buffer<std::int16_t> coarse_row_from_px;
    Buffer<float> source_x_px;  ///< image position of each mesh column
    Buffer<float> source_y_px;
    Buffer<float> vertex_x_px;
    Buffer<float> vertex_y_px;
    Buffer<float> vertex_inverse_depth;
    Buffer<float> cell_facing;  ///< see MeasureFacing
    Buffer<int> sample_counts;  ///< by tile

  private:
    HistoryImages history(int generation);
    SupportImages support_images(int generation);

    int current_ = 0;
    std::array<Buffer<Half4>, 2> colour_;
    std::array<Buffer<CacheInfo>, 2> info_;
    std::array<Buffer<Half4>, 2> light_;
    std::array<Buffer<Half4>, 2> support_colour_;
    std::array<Buffer<Half4>, 2> support_light_;
    std::array<Buffer<float>, 2> support_depth_m_;
    Buffer<std::uint8_t> block_boxes_;
    Buffer<float> coarse_values_;
    Buffer<std::uint8_t> coarse_marked_;
    Buffer<PackedPixel> sample_pixels_;
    Buffer<std::uint8_t> sample_flags_;
    Buffer<Half4> sample_colour_;
    Buffer<Half4> sample_light_;  ///< base, diffuse, light one after the other
};

}  // namespace foverig
