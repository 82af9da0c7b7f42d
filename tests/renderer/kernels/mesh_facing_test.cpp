#include "renderer/kernels/mesh_facing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace foverig {
namespace {

constexpr int kColumns = 12;
constexpr int kRows = 9;

/// A frame of 110 x 80 pixels at the DK2's left-eye tangents, and a mesh that ends at its corners.
struct View {
    View() {
        for (int i = 0; i < kColumns; ++i) x_px.push_back(static_cast<float>(10 * i));
        for (int i = 0; i < kRows; ++i) y_px.push_back(static_cast<float>(10 * i));
    }
    dvec3 direction(double x, double y) const {
        return {-1.058657 + x * per_px.x, -(-1.331603 + y * per_px.y), -1.0};
    }
    std::vector<float> measure() const {
        std::vector<float> facing(kColumns * kRows, -1.0F);
        const MeasureFacing kernel{depth_m.data(),           x_px.data(), y_px.data(),  per_px,
                                   {-1.058657F, -1.331603F}, kColumns,    facing.data()};
        for (int row = 0; row < kRows - 1; ++row) kernel(row);
        return facing;
    }

    vec2 per_px{(1.058657F + 1.092368F) / 110.0F, 2.0F * 1.331603F / 80.0F};
    std::vector<float> x_px;
    std::vector<float> y_px;
    std::vector<float> depth_m = std::vector<float>(kColumns * kRows, 2.0F);
};

TEST(MeasureFacing, OfAPlaneIsTheCosineOfItsNormalAndTheDirectionToTheEye) {
    for (const dvec3 towards :
         {dvec3(0, 0, 1), dvec3(0.6, 0, 1), dvec3(-0.2, 0.5, 1), dvec3(0, 3.0, 8.0)}) {
        const dvec3 normal = glm::normalize(towards);
        View view;
        for (int row = 0; row < kRows; ++row)
            for (int column = 0; column < kColumns; ++column)
                view.depth_m[static_cast<std::size_t>(row * kColumns + column)] =
                    static_cast<float>(-3.0 /
                                       glm::dot(normal, view.direction(10.0 * column, 10.0 * row)));
        const std::vector<float> facing = view.measure();
        for (int row = 0; row < kRows - 1; ++row)
            for (int column = 0; column < kColumns - 1; ++column) {
                const dvec3 d = view.direction(10.0 * column + 5.0, 10.0 * row + 5.0);
                EXPECT_NEAR(facing[static_cast<std::size_t>(row * kColumns + column)],
                            -glm::dot(normal, glm::normalize(d)), 2.0e-5)
                    << column << ' ' << row;
            }
    }
}

TEST(MeasureFacing, ACellThatClosesAGapRunsAlongTheViewAndItsNeighboursDoNot) {
    View view;
    for (int row = 0; row < kRows; ++row)
        for (int column = 6; column < kColumns; ++column)
            view.depth_m[static_cast<std::size_t>(row * kColumns + column)] = 20.0F;
    const std::vector<float> facing = view.measure();
    for (int column = 0; column < kColumns - 1; ++column) {
        if (column == 5)
            EXPECT_LT(facing[static_cast<std::size_t>(3 * kColumns + column)], 0.15F);
        else
            EXPECT_GT(facing[static_cast<std::size_t>(3 * kColumns + column)], 0.5F);
    }
}

TEST(MeasureFacing, OneCornerApartIsEnoughAndTheSkyIsFlat) {
    View view;
    std::fill(view.depth_m.begin(), view.depth_m.end(), kFarDepth_m);
    view.depth_m[4 * kColumns + 7] = 1.0F;
    const std::vector<float> facing = view.measure();
    for (int row = 0; row < kRows - 1; ++row)
        for (int column = 0; column < kColumns - 1; ++column) {
            const bool touches = (row == 3 || row == 4) && (column == 6 || column == 7);
            const float cosine = facing[static_cast<std::size_t>(row * kColumns + column)];
            ASSERT_TRUE(std::isfinite(cosine));
            EXPECT_EQ(cosine < 0.2F, touches) << column << ' ' << row << ' ' << cosine;
        }
}

}  // namespace
}  // namespace foverig
