#include "bench/mesh_fixture.h"

#include <algorithm>

#include "renderer/kernels/sampling.h"

namespace foverig::bench {
namespace {

constexpr std::size_t kTileFloats = static_cast<std::size_t>(kRasterTile) * kRasterStride;
constexpr std::size_t kPixels = static_cast<std::size_t>(kEyeWidth_px) * kEyeHeight_px;

EyeView eye_at(float x_m) {
    EyeView view;
    view.width_px = kEyeWidth_px;
    view.height_px = kEyeHeight_px;
    view.tan_left = 1.058657F;
    view.tan_right = 1.092368F;
    view.tan_up = view.tan_down = 1.331603F;
    view.position_m = {x_m, 0.0F, 0.0F};
    return view;
}

std::vector<float> axis(int count, int size_px) {
    std::vector<float> at(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        at[static_cast<std::size_t>(i)] =
            static_cast<float>(i) * static_cast<float>(size_px) / static_cast<float>(count - 1);
    return at;
}

}  // namespace

MeshFixture::MeshFixture(float shift_m)
    : depth_m_(kColumns * kRows, kWallDepth_m),
      source_x_px_(axis(kColumns, kEyeWidth_px)),
      source_y_px_(axis(kRows, kEyeHeight_px)),
      x_px_(depth_m_.size()),
      y_px_(depth_m_.size()),
      inverse_depth_(depth_m_.size()),
      tile_rows_(memory_, 4 * kTileFloats),
      from_colour_(memory_, kPixels),
      to_colour_(memory_, kPixels),
      from_info_(memory_, kPixels),
      to_info_(memory_, kPixels),
      vertices_{Reprojection(eye_at(0.0F), eye_at(shift_m)),
                depth_m_.data(),
                source_x_px_.data(),
                source_y_px_.data(),
                kColumns,
                x_px_.data(),
                y_px_.data(),
                inverse_depth_.data()} {
    for (std::size_t i = 0; i < kPixels; ++i) {
        const auto at = static_cast<std::uint32_t>(i);
        from_colour_[i] = pack_half4({unit_float(hash32(at, 1U)), unit_float(hash32(at, 2U)),
                                      unit_float(hash32(at, 3U)), 2.0F});
        from_info_[i] = touched_in(1U);
    }
    const int per_row = (kColumns - 1 + kBlockCells - 1) / kBlockCells;
    const auto side = static_cast<std::size_t>(per_row * (kRows - 1) + 7) / 8 * 8;
    block_boxes_.resize(4 * side);
    block_flags_.resize(side);
    std::uint8_t* const p = block_boxes_.data();
    blocks_ = {p, p + side, p + 2 * side, p + 3 * side, per_row, static_cast<int>(side)};
    for (int row = 0; row < kRows; ++row) vertices_(row);
    const BoundBlocks bound{mesh(),
                            blocks_,
                            19,
                            23,
                            1.0F / kRasterTile,
                            static_cast<float>(kEyeWidth_px),
                            static_cast<float>(kEyeHeight_px)};
    for (int row = 0; row + 1 < kRows; ++row) bound(row);
}

RasterTile MeshFixture::tile() {
    float* const p = tile_rows_.data();
    return {p, p + kTileFloats, p + 2 * kTileFloats, p + 3 * kTileFloats};
}

void MeshFixture::raster() {
    const RasterTile target = tile();
    std::fill_n(target.inverse_depth, kTileFloats, 0.0F);
    constexpr auto kColumn = static_cast<std::uint8_t>(kTileX_px / kRasterTile);
    constexpr auto kRow = static_cast<std::uint8_t>(kTileY_px / kRasterTile);
    visit_blocks(blocks_, {kColumn, kColumn, kRow, kRow}, block_flags_.data(), [&](int block) {
        raster_block(frame(), target, block / blocks_.per_row,
                     block % blocks_.per_row * kBlockCells);
    });
}

}  // namespace foverig::bench
