#include "renderer/kernels/resampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/renderer/kernels/mesh_arrays.h"

namespace foverig {
namespace {

constexpr int kColumns = 24;
constexpr int kRows = 18;
constexpr float kDepthStep = 0.1F;
constexpr float kLuminanceStep = 0.15F;
constexpr float kGrazing = 0.1F;

/// A coarse view that shows a flat, frontal, even wall 2 m away; a test disturbs it.
struct Coarse {
    Coarse()
        : inverse_depth(kColumns * kRows, 0.5F),
          luminance(kColumns * kRows, 0.4F),
          facing(kColumns * kRows, 1.0F),
          marked(kColumns * kRows, 77) {}

    static std::size_t at(int column, int row) {
        return static_cast<std::size_t>(row * kColumns + column);
    }
    void mark() {
        const MarkResampling kernel{
            {inverse_depth.data(), luminance.data(), facing.data(), marked.data(), kColumns, kRows},
            kDepthStep,
            kLuminanceStep,
            kGrazing};
        for (int row = 0; row < kRows; ++row) kernel(row);
    }
    bool is_marked(int column, int row) const { return marked[at(column, row)] != 0; }
    int count() const {
        int n = 0;
        for (const std::uint8_t m : marked) n += m != 0 ? 1 : 0;
        return n;
    }

    std::vector<float> inverse_depth;
    std::vector<float> luminance;
    std::vector<float> facing;
    std::vector<std::uint8_t> marked;
};

TEST(MarkResampling, AFlatFrontalWallIsNotMarked) {
    Coarse c;
    c.mark();
    EXPECT_EQ(c.count(), 0);
}

TEST(MarkResampling, ADepthStepMarksBothItsSidesAndNothingElse) {
    Coarse c;
    for (int row = 0; row < kRows; ++row)
        for (int column = 10; column < kColumns; ++column)
            c.inverse_depth[Coarse::at(column, row)] = 0.5F / 1.2F;
    c.mark();
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column)
            ASSERT_EQ(c.is_marked(column, row), column == 9 || column == 10) << column;
}

TEST(MarkResampling, TheDepthStepIsRelativeToTheNearerDepth) {
    for (const double step : {1.09, 1.11}) {
        for (const double depth_m : {0.3, 5.0, 900.0}) {
            Coarse c;
            for (float& d : c.inverse_depth) d = static_cast<float>(1.0 / depth_m);
            c.inverse_depth[Coarse::at(5, 5)] = static_cast<float>(1.0 / (depth_m * step));
            c.mark();
            EXPECT_EQ(c.count(), step > 1.1 ? 5 : 0) << depth_m << ' ' << step;
        }
    }
}

TEST(MarkResampling, ALuminanceStepMarks) {
    Coarse c;
    c.luminance[Coarse::at(0, 0)] = 0.54F;  // below the threshold
    c.luminance[Coarse::at(12, 7)] = 0.56F;
    c.mark();
    EXPECT_EQ(c.count(), 5);
    for (const auto& [column, row] :
         {std::pair{12, 7}, std::pair{11, 7}, std::pair{13, 7}, std::pair{12, 6}, std::pair{12, 8}})
        EXPECT_TRUE(c.is_marked(column, row));
}

TEST(MarkResampling, AGrazingSurfaceMarksItselfAlone) {
    Coarse c;
    c.facing[Coarse::at(3, 4)] = 0.09F;
    c.facing[Coarse::at(8, 8)] = 0.0F;
    c.facing[Coarse::at(15, 15)] = 0.11F;
    c.mark();
    EXPECT_EQ(c.count(), 2);
    EXPECT_TRUE(c.is_marked(3, 4));
    EXPECT_TRUE(c.is_marked(8, 8));
}

TEST(MarkResampling, TheBorderOfAHoleIsMarkedOnBothSidesButNotItsInside) {
    Coarse c;
    for (int row = 6; row < 12; ++row)
        for (int column = 6; column < 14; ++column) c.inverse_depth[Coarse::at(column, row)] = 0.0F;
    c.mark();
    EXPECT_TRUE(c.is_marked(5, 8));
    EXPECT_TRUE(c.is_marked(6, 8));
    EXPECT_FALSE(c.is_marked(4, 8));
    EXPECT_FALSE(c.is_marked(9, 9));
}

TEST(MarkResampling, TheImagesOwnBorderIsNoStep) {
    Coarse c;
    for (int row = 0; row < kRows; ++row) c.inverse_depth[Coarse::at(0, row)] = 0.52F;
    c.mark();
    EXPECT_EQ(c.count(), 0);
}

/// The resolve of one row against a one-coloured last frame; the mesh cell there has `facing`.
float resolved_facing(float facing, float* luminance = nullptr) {
    RasterArrays raster;
    const std::size_t at = RasterArrays::index(3, 5);
    raster.inverse_depth[at] = 0.25F;
    raster.source_x_w[at] = 35.0F * 0.25F;
    raster.source_y_w[at] = 59.0F * 0.25F;
    std::vector<Half4> colour(100 * 100);
    colour[59 * 100 + 35] = pack_half4({0.0F, 0.25F, 0.0F, 0.0F});
    std::vector<float> cell_facing(10 * 10, 1.0F);
    cell_facing[53] = facing;  // between vertices 3 and 4, 5 and 6: pixels 33 to 44, 55 to 66
    Coarse c;
    const CoarseView coarse{
        c.inverse_depth.data(), c.luminance.data(), c.facing.data(), c.marked.data(), 10, 10};
    const ResolveCoarse kernel{raster.tile(),
                               coarse,
                               colour.data(),
                               100,
                               100,
                               cell_facing.data(),
                               10,
                               10,
                               9.0F / 99.0F,
                               9.0F / 99.0F,
                               0,
                               0,
                               10};
    kernel(5);
    if (luminance != nullptr) *luminance = c.luminance[53];
    EXPECT_EQ(c.inverse_depth[53], 0.25F);
    EXPECT_EQ(c.inverse_depth[54], 0.0F);  // nothing was drawn there
    return c.facing[53];
}

TEST(ResolveCoarse, FacingIsThatOfTheMeshCellDrawnThere) {
    EXPECT_EQ(resolved_facing(0.07F), 0.07F);
}

TEST(ResolveCoarse, LuminanceIsTheRootOfTheLastFramesThere) {
    float luminance = 0.0F;
    resolved_facing(1.0F, &luminance);
    EXPECT_NEAR(luminance, std::sqrt(0.7152 * 0.25), 1.0e-3);
}

TEST(CoarseLookup, IsFalseEverywhereWithoutHistory) {
    const CoarseLookup lookup;
    EXPECT_FALSE(lookup(0, 0));
    EXPECT_FALSE(lookup(500, 900));
}

}  // namespace
}  // namespace foverig
