// The mesh drawn over a whole frame by keys, against the tiles of raster.h, pixel by pixel.
#include "renderer/kernels/frame_raster.h"

#include <gtest/gtest.h>

#include <numeric>

#include "renderer/kernels/sampling.h"
#include "tests/renderer/kernels/mesh_arrays.h"

namespace foverig {
namespace {

/// Vertices strewn over the image and beyond: cells fold, overlap, are huge or tiny, and some
/// corners cannot be seen. Depths repeat, so that there are ties.
MeshArrays strewn(int columns, int rows, const TileGrid& grid, float spread, std::uint32_t seed) {
    MeshArrays mesh(columns, rows);
    const auto random = [seed](std::uint32_t i) { return unit_float(hash32(seed, i)); };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const auto at = mesh.at(column, row);
            const auto i = static_cast<std::uint32_t>(4 * at);
            const auto place = [&](int k, int n, int size_px, float stray) {
                return static_cast<float>(size_px) *
                       ((static_cast<float>(k) / static_cast<float>(n - 1) - 0.5F) * 1.1F + 0.5F +
                        spread * (stray - 0.5F));
            };
            mesh.x_px[at] = place(column, columns, grid.width_px, random(i));
            mesh.y_px[at] = place(row, rows, grid.height_px, random(i + 1));
            mesh.inverse_depth[at] =
                random(i + 2) < 0.05F ? 0.0F : 0.25F * (1.0F + std::floor(4.0F * random(i + 3)));
        }
    }
    std::iota(mesh.source_x_px.begin(), mesh.source_x_px.end(), 3.0F);
    std::iota(mesh.source_y_px.begin(), mesh.source_y_px.end(), 5.0F);
    return mesh;
}

/// Targets of a whole frame; cells drawn last first, as a GPU may.
struct FrameTargets {
    explicit FrameTargets(const TileGrid& grid_, int cells)
        : grid(grid_),
          keys(static_cast<std::size_t>(grid.count()) * kTilePixels, 77),
          large(static_cast<std::size_t>(cells)),
          planes(4, std::vector<float>(static_cast<std::size_t>(grid.count()) * kRasterTileFloats +
                                       kLanes)) {}

    FrameRaster raster() { return {keys.data(), large.data(), &large_count, grid}; }
    RasterTile tiles() {
        return {planes[0].data(), planes[1].data(), planes[2].data(), planes[3].data()};
    }
    void draw(const RasterFrame& frame) {
        const auto run = [](int n, const auto& kernel) {
            for (int i = n; i-- > 0;) kernel(i);
        };
        run(ResolveRaster::count(grid), ClearRaster{raster()});
        run(RasterCells::count(frame.mesh), RasterCells{frame, raster()});
        run(RasterLargeCells::count(grid), RasterLargeCells{frame, raster()});
        run(ResolveRaster::count(grid), ResolveRaster{frame, keys.data(), tiles(), grid});
    }

    TileGrid grid;
    std::vector<RasterKey> keys;
    std::vector<int> large;
    int large_count = -1;
    std::vector<std::vector<float>> planes;
};

/// Returns the cells that were large.
int expect_as_tiles(const MeshArrays& mesh, const TileGrid& grid, float scale) {
    RasterFrame frame;
    frame.mesh = mesh.mesh();
    frame.scale_x = frame.scale_y = scale;
    FrameTargets drawn(grid, mesh.columns * mesh.rows);
    drawn.draw(frame);
    int covered = 0;
    for (int tile = 0; tile < grid.count(); ++tile) {
        const TileRect rect = grid.rect(tile);
        RasterArrays expected;
        raster_all(frame_of_tile(frame, rect), expected.tile());
        for (int y = 0; y < rect.height; ++y) {
            for (int x = 0; x < rect.width; ++x) {
                const std::size_t at = RasterArrays::index(x, y);
                const std::size_t in_frame =
                    static_cast<std::size_t>(tile) * kRasterTileFloats + at;
                EXPECT_EQ(drawn.planes[0][in_frame], expected.inverse_depth[at]);
                if (expected.inverse_depth[at] <= 0.0F) continue;
                ++covered;
                EXPECT_EQ(drawn.planes[1][in_frame], expected.source_x_w[at]);
                EXPECT_EQ(drawn.planes[2][in_frame], expected.source_y_w[at]);
                EXPECT_EQ(drawn.planes[3][in_frame], expected.magnification[at]);
            }
        }
        if (testing::Test::HasFailure()) {
            ADD_FAILURE() << "in tile " << tile;
            return drawn.large_count;
        }
    }
    EXPECT_GT(covered, grid.width_px * grid.height_px / 2);
    return drawn.large_count;
}

TEST(FrameRaster, DrawsWhatTilesDrawInAnyOrderOfCells) {
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
        const TileGrid grid{150, 133};
        EXPECT_EQ(expect_as_tiles(strewn(41, 37, grid, 0.05F, seed), grid, 1.0F), 0);
    }
}

TEST(FrameRaster, DrawsCellsThatAreTooLargeForAThread) {
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
        const TileGrid grid{200, 133};
        EXPECT_GT(expect_as_tiles(strewn(9, 7, grid, 0.6F, seed), grid, 1.0F), 20);
    }
}

TEST(FrameRaster, DrawsAtAnotherScale) {
    const TileGrid grid{70, 90};
    expect_as_tiles(strewn(35, 45, {280, 360}, 0.05F, 3), grid, 0.25F);
}

TEST(RasterKey, TheNearestWinsAndOfEqualsTheFirst) {
    EXPECT_GT(raster_key(0.5F, 9), raster_key(0.25F, 0));
    EXPECT_GT(raster_key(0.5F, 3), raster_key(0.5F, 4));
    EXPECT_GT(raster_key(1.0e-30F, 0xFFFFFFFEU), RasterKey{0});
    EXPECT_EQ(key_inverse_depth(raster_key(0.3F, 12345)), 0.3F);
    EXPECT_EQ(key_triangle(raster_key(0.3F, 12345)), 12345U);
}

}  // namespace
}  // namespace foverig
