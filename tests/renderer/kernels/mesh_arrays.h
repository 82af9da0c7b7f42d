#pragma once
// A depth mesh whose vertices a test places itself, and a raster target with room around it.
#include <algorithm>
#include <vector>

#include "renderer/kernels/raster.h"

namespace foverig {

struct MeshArrays {
    MeshArrays(int columns_, int rows_)
        : columns(columns_),
          rows(rows_),
          x_px(cells() + kPast),
          y_px(cells() + kPast),
          inverse_depth(cells() + kPast, 1.0F),
          source_x_px(static_cast<std::size_t>(columns_) + kPast),
          source_y_px(static_cast<std::size_t>(rows_) + kPast) {}

    static constexpr std::size_t kPast =
        2 * kBlockCells;  ///< the last vector of a row reads past it

    std::size_t cells() const {
        return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }
    std::size_t at(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
    DepthMesh mesh() const {
        return {
            x_px.data(), y_px.data(), inverse_depth.data(), source_x_px.data(), source_y_px.data(),
            columns,     rows};
    }

    int columns;
    int rows;
    std::vector<float> x_px;
    std::vector<float> y_px;
    std::vector<float> inverse_depth;
    std::vector<float> source_x_px;
    std::vector<float> source_y_px;
};

struct RasterArrays {
    static constexpr std::size_t kFloats =
        static_cast<std::size_t>(kRasterTile) * kRasterStride + 64;

    RasterTile tile() {
        return {inverse_depth.data(), source_x_w.data(), source_y_w.data(), magnification.data()};
    }
    float depth_at(int x, int y) const { return inverse_depth[index(x, y)]; }
    static std::size_t index(int x, int y) {
        return static_cast<std::size_t>(y * kRasterStride + x);
    }

    std::vector<float> inverse_depth = std::vector<float>(kFloats);
    std::vector<float> source_x_w = std::vector<float>(kFloats);
    std::vector<float> source_y_w = std::vector<float>(kFloats);
    std::vector<float> magnification = std::vector<float>(kFloats);
};

/// Every cell, in rising order.
inline void raster_all(const RasterFrame& frame, const RasterTile& tile) {
    for (int row = 0; row + 1 < frame.mesh.rows; ++row)
        for (int column = 0; column + 1 < frame.mesh.columns; column += kBlockCells)
            raster_block(frame, tile, row, column);
}

}  // namespace foverig
