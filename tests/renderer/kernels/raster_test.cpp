#include "renderer/kernels/raster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "renderer/kernels/sampling.h"
#include "tests/renderer/kernels/mesh_arrays.h"

namespace foverig {
namespace {

float random(std::uint32_t seed, std::uint32_t i) {
    return unit_float(hash32(seed, i));
}

/// A grid a little larger than the tile whose vertices stray by less than half a cell: it covers
/// the tile and no cell folds over. Positions are multiples of 1/`fraction` px.
MeshArrays jittered_grid(int cells, float fraction, std::uint32_t seed) {
    MeshArrays mesh(cells + 1, cells + 1);
    const float step = 80.0F / static_cast<float>(cells);
    for (int row = 0; row <= cells; ++row) {
        for (int column = 0; column <= cells; ++column) {
            const auto i = static_cast<std::uint32_t>(mesh.at(column, row));
            const auto place = [&](int k, float jitter) {
                return std::round(
                           (-8.0F + step * (static_cast<float>(k) + 0.6F * (jitter - 0.5F))) *
                           fraction) /
                       fraction;
            };
            mesh.x_px[i] = place(column, random(seed, 2 * i));
            mesh.y_px[i] = place(row, random(seed, 2 * i + 1));
        }
        mesh.source_x_px[static_cast<std::size_t>(row)] = step * static_cast<float>(row);
        mesh.source_y_px[static_cast<std::size_t>(row)] = step * static_cast<float>(row);
    }
    return mesh;
}

/// Sets the first values and leaves the room past them.
void place(std::vector<float>& to, std::initializer_list<float> values) {
    std::copy(values.begin(), values.end(), to.begin());
}

struct Point {
    double x, y;
};

double edge(const Point& a, const Point& b, const Point& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// How far inside the triangle the point lies, px; negative outside.
double depth_inside(const Point& a, const Point& b, const Point& c, const Point& p) {
    const double sign = edge(a, b, c) < 0.0 ? -1.0 : 1.0;
    const auto distance = [&](const Point& s, const Point& e) {
        return sign * edge(s, e, p) / std::hypot(e.x - s.x, e.y - s.y);
    };
    return std::min({distance(a, b), distance(b, c), distance(c, a)});
}

Point vertex(const MeshArrays& m, int column, int row) {
    return {m.x_px[m.at(column, row)], m.y_px[m.at(column, row)]};
}

TEST(Raster, LeavesNoGapBetweenCellsAtAnySubpixelPosition) {
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        for (const int cells : {5, 16, 40, 100}) {
            const MeshArrays mesh = jittered_grid(cells, seed < 6 ? 4096.0F : 2.0F,
                                                  seed);  // the latter puts edges through centres
            RasterArrays target;
            raster_all({mesh.mesh()}, target.tile());
            for (int y = 0; y < kRasterTile; ++y)
                for (int x = 0; x < kRasterTile; ++x)
                    ASSERT_GT(target.depth_at(x, y), 0.0F)
                        << x << ' ' << y << " of " << cells << ", seed " << seed;
        }
    }
}

TEST(Raster, DrawsACellExactlyWhereItIs) {
    // A quad alone, against exact half-planes in double; only centres within 1e-3 px of an edge may
    // go either way.
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        MeshArrays mesh(2, 2);
        for (std::uint32_t i = 0; i < 4; ++i) {
            mesh.x_px[i] = 90.0F * random(seed, 2 * i) - 13.0F;
            mesh.y_px[i] = 90.0F * random(seed, 2 * i + 1) - 13.0F;
        }
        mesh.source_x_px[1] = mesh.source_y_px[1] = 1.0F;
        RasterArrays target;
        raster_all({mesh.mesh()}, target.tile());
        const Point a = vertex(mesh, 0, 0);
        const Point b = vertex(mesh, 1, 0);
        const Point c = vertex(mesh, 0, 1);
        const Point d = vertex(mesh, 1, 1);
        for (int y = 0; y < kRasterTile; ++y) {
            for (int x = 0; x < kRasterTile; ++x) {
                const Point p{x + 0.5, y + 0.5};
                const double inside = std::max(depth_inside(a, b, d, p), depth_inside(a, d, c, p));
                if (std::abs(inside) < 1.0e-3) continue;
                ASSERT_EQ(target.depth_at(x, y) > 0.0F, inside > 0.0)
                    << x << ' ' << y << " seed " << seed << " inside " << inside;
            }
        }
    }
}

TEST(Raster, InterpolatesWithPerspective) {
    // 1/depth and source/depth are linear over the screen: barycentrics in double.
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        MeshArrays mesh(2, 2);
        const float quad[4][2] = {{-3.0F, -5.0F}, {70.0F, -2.0F}, {-4.0F, 69.0F}, {67.0F, 71.0F}};
        for (std::uint32_t i = 0; i < 4; ++i) {
            mesh.x_px[i] = quad[i][0] + 20.0F * random(seed, 3 * i);
            mesh.y_px[i] = quad[i][1] + 20.0F * random(seed, 3 * i + 1);
            mesh.inverse_depth[i] = 0.05F + random(seed, 3 * i + 2);
        }
        place(mesh.source_x_px, {512.5F, 517.5F});
        place(mesh.source_y_px, {1020.5F, 1024.5F});
        RasterArrays target;
        raster_all({mesh.mesh()}, target.tile());
        const Point a = vertex(mesh, 0, 0);
        const Point d = vertex(mesh, 1, 1);
        for (int y = 0; y < kRasterTile; ++y) {
            for (int x = 0; x < kRasterTile; ++x) {
                const Point p{x + 0.5, y + 0.5};
                for (int half = 0; half < 2; ++half) {
                    const int column = half == 0 ? 1 : 0;
                    const Point m = vertex(mesh, column, 1 - column);
                    if (depth_inside(a, m, d, p) < 1.0e-2) continue;
                    const double area = edge(a, m, d);
                    const double wm = edge(d, a, p) / area;
                    const double wd = edge(a, m, p) / area;
                    const double wa = 1.0 - wm - wd;
                    const double ia = wa * static_cast<double>(mesh.inverse_depth[0]);
                    const double im =
                        wm * static_cast<double>(mesh.inverse_depth[mesh.at(column, 1 - column)]);
                    const double id = wd * static_cast<double>(mesh.inverse_depth[3]);
                    const double inverse = ia + im + id;
                    const double middle_x =
                        static_cast<double>(mesh.source_x_px[static_cast<std::size_t>(column)]);
                    const double middle_y =
                        static_cast<double>(mesh.source_y_px[static_cast<std::size_t>(1 - column)]);
                    const std::size_t at = RasterArrays::index(x, y);
                    ASSERT_NEAR(target.inverse_depth[at], inverse, 2.0e-5 * inverse);
                    ASSERT_NEAR(target.source_x_w[at] / target.inverse_depth[at],
                                (512.5 * ia + middle_x * im + 517.5 * id) / inverse, 5.0e-3);
                    ASSERT_NEAR(target.source_y_w[at] / target.inverse_depth[at],
                                (1020.5 * ia + middle_y * im + 1024.5 * id) / inverse, 5.0e-3);
                }
            }
        }
    }
}

TEST(Raster, TheNearestSurfaceWinsInWhateverOrder) {
    MeshArrays near = jittered_grid(10, 4096.0F, 1);
    MeshArrays far = jittered_grid(7, 4096.0F, 2);
    for (int row = 0; row <= 10; ++row)
        for (int column = 0; column <= 10; ++column)
            if (row < 5)
                near.inverse_depth[near.at(column, row)] = 0.0F;  // unseen: the far one shows
    std::fill(far.inverse_depth.begin(), far.inverse_depth.end(), 0.25F);
    RasterArrays near_first;
    raster_all({near.mesh()}, near_first.tile());
    raster_all({far.mesh()}, near_first.tile());
    RasterArrays far_first;
    raster_all({far.mesh()}, far_first.tile());
    raster_all({near.mesh()}, far_first.tile());
    EXPECT_EQ(near_first.inverse_depth, far_first.inverse_depth);
    EXPECT_EQ(near_first.source_x_w, far_first.source_x_w);
    EXPECT_EQ(near_first.depth_at(30, 5), 0.25F);
    EXPECT_EQ(near_first.depth_at(30, 60), 1.0F);
}

TEST(Raster, ACellWithAnUnseenCornerIsLeftOut) {
    MeshArrays mesh = jittered_grid(4, 4096.0F, 3);
    std::fill(mesh.inverse_depth.begin(), mesh.inverse_depth.end(), 0.0F);
    RasterArrays target;
    raster_all({mesh.mesh()}, target.tile());
    for (const float d : target.inverse_depth) ASSERT_EQ(d, 0.0F);
}

TEST(Raster, WhereATileBeginsDoesNotChangeWhatItShows) {
    // Vertices on eighths and edges short enough for exact products: coverage agrees to the pixel.
    const MeshArrays mesh = jittered_grid(16, 8.0F, 9);
    RasterArrays whole;
    raster_all({mesh.mesh()}, whole.tile());
    for (const int shift : {1, 8, 19, 32}) {
        RasterArrays part;
        RasterFrame frame{mesh.mesh()};
        frame.x0 = shift;
        frame.y0 = shift;
        frame.width = kRasterTile - shift;
        frame.height = kRasterTile - shift;
        raster_all(frame, part.tile());
        for (int y = shift; y < kRasterTile; ++y) {
            for (int x = shift; x < kRasterTile; ++x) {
                const std::size_t there = RasterArrays::index(x - shift, y - shift);
                const std::size_t here = RasterArrays::index(x, y);
                ASSERT_NEAR(part.inverse_depth[there], whole.inverse_depth[here], 1.0e-5);
                ASSERT_NEAR(part.source_x_w[there], whole.source_x_w[here], 1.0e-3);
                ASSERT_NEAR(part.source_y_w[there], whole.source_y_w[here], 1.0e-3);
            }
        }
    }
}

TEST(Raster, ScalesMeshPixelsToTargetPixels) {
    MeshArrays mesh(2, 2);
    place(mesh.x_px, {0.0F, 40.0F, 0.0F, 40.0F});
    place(mesh.y_px, {0.0F, 0.0F, 80.0F, 80.0F});
    place(mesh.source_x_px, {0.0F, 40.0F});
    place(mesh.source_y_px, {0.0F, 80.0F});
    RasterArrays target;
    raster_all({mesh.mesh(), 0.25F, 0.5F}, target.tile());
    for (int y = 0; y < kRasterTile; ++y)
        for (int x = 0; x < kRasterTile; ++x)
            ASSERT_EQ(target.depth_at(x, y) > 0.0F, x < 10 && y < 40) << x << ' ' << y;
    EXPECT_NEAR(target.source_x_w[RasterArrays::index(3, 7)], 14.0F, 1.0e-4F);
    EXPECT_NEAR(target.source_y_w[RasterArrays::index(3, 7)], 15.0F, 1.0e-4F);
}

TEST(Raster, KeepsTheAreaOfANewPixelInTheOldImage) {
    MeshArrays mesh(2, 2);
    place(mesh.x_px, {0.0F, 32.0F, 0.0F, 32.0F});
    place(mesh.y_px, {0.0F, 0.0F, 16.0F, 16.0F});
    place(mesh.source_x_px, {100.0F, 132.0F});
    place(mesh.source_y_px, {50.0F, 114.0F});  // 32 x 64 old pixels on 32 x 16 new ones
    RasterArrays target;
    raster_all({mesh.mesh()}, target.tile());
    EXPECT_NEAR(target.magnification[RasterArrays::index(9, 9)], 4.0F, 1.0e-5F);
}

TEST(VisitBlocks, FindsEveryCellThatATileShows) {
    // The blocks a tile visits draw the same image as all blocks.
    MeshArrays mesh(60, 40);
    for (int row = 0; row < 40; ++row) {
        for (int column = 0; column < 60; ++column) {
            const auto i = static_cast<std::uint32_t>(mesh.at(column, row));
            mesh.x_px[i] = 6.0F * static_cast<float>(column) - 20.0F + 40.0F * random(5, 2 * i);
            mesh.y_px[i] = 6.0F * static_cast<float>(row) - 20.0F + 40.0F * random(5, 2 * i + 1);
            mesh.inverse_depth[i] = random(6, i) < 0.1F ? 0.0F : 0.5F + random(7, i);
        }
    }
    constexpr int kColumns = 5;
    constexpr int kRows = 3;
    const int per_row = (59 + kBlockCells - 1) / kBlockCells;
    const auto count = static_cast<std::size_t>((per_row * 39 + 7) / 8 * 8);
    std::vector<std::uint8_t> boxes(4 * count);
    std::uint8_t* const p = boxes.data();
    const CellBlocks blocks{
        p, p + count, p + 2 * count, p + 3 * count, per_row, static_cast<int>(count)};
    std::fill(p, p + count, std::uint8_t{255});
    const BoundBlocks bound{mesh.mesh(),  blocks,           kColumns,     kRows,
                            1.0F / 64.0F, 64.0F * kColumns, 64.0F * kRows};
    for (int row = 0; row < 39; ++row) bound(row);
    for (int tile = 0; tile < kColumns * kRows; ++tile) {
        RasterFrame frame{mesh.mesh()};
        frame.x0 = 64 * (tile % kColumns);
        frame.y0 = 64 * (tile / kColumns);
        RasterArrays all;
        raster_all(frame, all.tile());
        RasterArrays some;
        std::vector<std::uint8_t> flags(count);
        const auto c = static_cast<std::uint8_t>(tile % kColumns);
        const auto r = static_cast<std::uint8_t>(tile / kColumns);
        int visited = 0;
        visit_blocks(blocks, {c, c, r, r}, flags.data(), [&](int block) {
            ++visited;
            raster_block(frame, some.tile(), block / per_row, block % per_row * kBlockCells);
        });
        EXPECT_EQ(some.inverse_depth, all.inverse_depth) << tile;
        EXPECT_EQ(some.source_x_w, all.source_x_w) << tile;
        EXPECT_LT(visited, per_row * 39 / 2) << tile;
    }
}

}  // namespace
}  // namespace foverig
