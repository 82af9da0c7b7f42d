#pragma once
// Which runs of mesh cells a tile must look at. A block is eight cells of one row; its box is kept
// in tiles, a byte a side, so that a tile finds its blocks by a scan that vectorises, whatever the
// motion.
#include <cstdint>
#include <cstring>

#include "renderer/kernels/depth_mesh.h"

namespace foverig {

inline constexpr int kBlockCells = 8;

struct CellBlocks {
    std::uint8_t* column0 = nullptr;  ///< inclusive range of tile columns and rows
    std::uint8_t* column1 = nullptr;
    std::uint8_t* row0 = nullptr;
    std::uint8_t* row1 = nullptr;
    int per_row = 0;
    int count = 0;  ///< padded to 8 with empty blocks
};

/// Tile index of a position, clamped to a byte; positions off the image go to its nearest tile.
RIG_INLINE std::uint8_t tile_index(float position_px, float inverse_tile_px, int tiles) {
    const float t =
        min_of(max_of(position_px * inverse_tile_px, 0.0F), static_cast<float>(tiles - 1));
    return static_cast<std::uint8_t>(t);
}

/// Boxes of all blocks of one row of cells. Cells with an unseen corner do not count.
struct BoundBlocks {
    DepthMesh mesh;
    CellBlocks blocks;
    int tile_columns;
    int tile_rows;
    float inverse_tile_px;
    float width_px;
    float height_px;

    RIG_HD void operator()(int row) const {
        for (int b = 0; b < blocks.per_row; ++b) {
            float x0 = 3.0e38F;
            float y0 = 3.0e38F;
            float x1 = -3.0e38F;
            float y1 = -3.0e38F;
            const int begin = b * kBlockCells;
            const int end =
                begin + kBlockCells < mesh.columns - 1 ? begin + kBlockCells : mesh.columns - 1;
            for (int line = row; line <= row + 1; ++line) {
                for (int column = begin; column <= end; ++column) {
                    const int v = line * mesh.columns + column;
                    const bool seen = mesh.inverse_depth[v] > 0.0F;
                    x0 = min_of(x0, seen ? mesh.x_px[v] : x0);
                    x1 = max_of(x1, seen ? mesh.x_px[v] : x1);
                    y0 = min_of(y0, seen ? mesh.y_px[v] : y0);
                    y1 = max_of(y1, seen ? mesh.y_px[v] : y1);
                }
            }
            const int block = row * blocks.per_row + b;
            const bool visible = x1 > 0.0F && y1 > 0.0F && x0 < width_px && y0 < height_px;
            blocks.column0[block] =
                visible ? tile_index(x0, inverse_tile_px, tile_columns) : std::uint8_t{255};
            blocks.column1[block] =
                visible ? tile_index(x1, inverse_tile_px, tile_columns) : std::uint8_t{0};
            blocks.row0[block] =
                visible ? tile_index(y0, inverse_tile_px, tile_rows) : std::uint8_t{255};
            blocks.row1[block] =
                visible ? tile_index(y1, inverse_tile_px, tile_rows) : std::uint8_t{0};
        }
    }
};

/// Inclusive ranges of tiles.
struct TileRange {
    std::uint8_t column0 = 0;
    std::uint8_t column1 = 0;
    std::uint8_t row0 = 0;
    std::uint8_t row1 = 0;
};

/// Calls visit(block) in rising order for every block whose box meets the range. `flags` has room
/// for `blocks.count` bytes.
template <class Visit>
RIG_HD void visit_blocks(const CellBlocks& blocks, const TileRange& range, std::uint8_t* flags,
                         const Visit& visit) {
    const CellBlocks b = blocks;
    const TileRange r = range;
    const int n = b.count;
#pragma GCC ivdep
    for (int i = 0; i < n; ++i) {
        const int meets = (b.column0[i] <= r.column1) & (b.column1[i] >= r.column0) &
                          (b.row0[i] <= r.row1) & (b.row1[i] >= r.row0);
        flags[i] = static_cast<std::uint8_t>(meets);
    }
    for (int i = 0; i < n; i += 8) {
        std::uint64_t word;
        memcpy(&word, flags + i, sizeof word);
        if (word == 0) continue;
        for (int k = 0; k < 8; ++k)
            if (flags[i + k] != 0) visit(i + k);
    }
}

}  // namespace foverig
