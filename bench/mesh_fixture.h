#pragma once
// One eye at DK2 size before a wall 4 m away, as the kernels of `reprojected` see it.
#include <vector>

#include "renderer/buffer.h"
#include "renderer/kernels/raster.h"
#include "renderer/kernels/reproject_pixels.h"

namespace foverig::bench {

inline constexpr int kEyeWidth_px = 1182;
inline constexpr int kEyeHeight_px = 1464;
inline constexpr int kTileX_px = 576;  ///< a whole tile in the middle
inline constexpr int kTileY_px = 704;
inline constexpr float kWallDepth_m = 4.0F;

class MeshFixture {
  public:
    /// The eye moves `shift_m` to the right between the two frames.
    explicit MeshFixture(float shift_m);

    const ReprojectVertices& vertices() const { return vertices_; }
    DepthMesh mesh() const {
        return {x_px_.data(),
                y_px_.data(),
                inverse_depth_.data(),
                source_x_px_.data(),
                source_y_px_.data(),
                kColumns,
                kRows};
    }
    RasterFrame frame() const {
        return {mesh(), 1.0F, 1.0F, kTileX_px, kTileY_px, kRasterTile, kRasterTile};
    }
    RasterTile tile();
    /// Clears the tile and draws what meets it, as a pipeline does.
    void raster();

    HistoryImages from() { return {from_colour_.data(), from_info_.data(), nullptr}; }
    HistoryImages to() { return {to_colour_.data(), to_info_.data(), nullptr}; }
    static std::size_t pixel(int x, int y) {
        return static_cast<std::size_t>(y) * kEyeWidth_px + static_cast<std::size_t>(x);
    }

  private:
    static constexpr int kColumns = 256;
    static constexpr int kRows = 318;

    MemoryCount memory_;
    std::vector<float> depth_m_, source_x_px_, source_y_px_, x_px_, y_px_, inverse_depth_;
    std::vector<std::uint8_t> block_boxes_, block_flags_;
    Buffer<float> tile_rows_;
    Buffer<Half4> from_colour_, to_colour_;
    Buffer<CacheInfo> from_info_, to_info_;
    ReprojectVertices vertices_;
    CellBlocks blocks_;
};

}  // namespace foverig::bench
