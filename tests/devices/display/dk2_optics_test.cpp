#include "devices/display/dk2_optics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace foverig {
namespace {

const Dk2Optics kOptics;
constexpr Channel kChannels[] = {Channel::red, Channel::green, Channel::blue};

// Numbers of DEVICES.md 2.2; the last digits are those of a public LibOVR dump where it has them.
TEST(Dk2Optics, FrustumIsLibOvrs) {
    const TangentFrustum left = kOptics.frustum(Eye::left);
    EXPECT_NEAR(left.up, 1.331603, 5e-7);
    EXPECT_NEAR(left.down, 1.331603, 5e-7);
    EXPECT_NEAR(left.left, 1.05865765, 5e-7);
    EXPECT_NEAR(left.right, 1.09236801, 5e-7);
    const TangentFrustum right = kOptics.frustum(Eye::right);
    EXPECT_DOUBLE_EQ(right.left, left.right);
    EXPECT_DOUBLE_EQ(right.right, left.left);
}

TEST(Dk2Optics, TextureAndPixelDensityAreLibOvrs) {
    EXPECT_NEAR(kOptics.pixels_per_tan_at_center(), 549.618286, 5e-4);
    EXPECT_EQ(kOptics.texture_size(), (SizePx{1182, 1464}));
}

TEST(Dk2Optics, ScaleGoesThroughEachKButTheFirst) {
    const double k[] = {1.0, 1.020, 1.042, 1.066, 1.094, 1.126, 1.162, 1.203, 1.250, 1.310, 1.380};
    for (int i = 0; i <= 10; ++i) EXPECT_NEAR(kOptics.scale(0.1 * i), k[i], 1e-12) << i;
    EXPECT_NEAR(kOptics.scale(1.5), 1.380 + 5 * 0.070, 1e-12);
}

TEST(Dk2Optics, ScaleIsSmoothAcrossSegments) {
    for (int i = 1; i < 10; ++i) {
        const double knot = 0.1 * i, h = 1e-6;
        const double before = (kOptics.scale(knot) - kOptics.scale(knot - h)) / h;
        const double after = (kOptics.scale(knot + h) - kOptics.scale(knot)) / h;
        EXPECT_NEAR(before, after, 1e-4) << i;
    }
}

TEST(Dk2Optics, ChromaIsInterpolatedToElevenMillimetres) {
    // DEVICES.md 2.1: -0.01234, -0.0165, +0.02059, +0.0165.
    EXPECT_NEAR(kOptics.scale(0, Channel::red), 1 - 0.01234, 1e-12);
    EXPECT_NEAR(kOptics.scale(1, Channel::red) / kOptics.scale(1), 1 - 0.01234 - 0.0165, 1e-12);
    EXPECT_NEAR(kOptics.scale(0, Channel::blue), 1 + 0.02059, 1e-12);
    EXPECT_NEAR(kOptics.scale(1, Channel::blue) / kOptics.scale(1), 1 + 0.02059 + 0.0165, 1e-12);
}

TEST(Dk2Optics, InverseUndoesEveryChannel) {
    for (const Channel channel : kChannels) {
        for (double r = 0; r < 1.4; r += 0.00137) {
            const double back = kOptics.inverse(r * kOptics.scale(r * r, channel), channel);
            ASSERT_NEAR(back, r, 1e-12) << r;
        }
    }
}

TEST(Dk2Optics, InverseIsTameForWhatNoPanelShows) {
    EXPECT_EQ(kOptics.inverse(0), 0);
    EXPECT_EQ(kOptics.inverse(1e300), 4);
    EXPECT_TRUE(std::isnan(kOptics.inverse(std::nan(""))));  // not hidden, so that it gets counted
}

TEST(Dk2Optics, PanelAndTangentSpaceAreInverse) {
    for (const Eye eye : {Eye::left, Eye::right}) {
        for (const Channel channel : kChannels) {
            for (double x = -1; x <= 1; x += 0.19) {
                for (double y = -1; y <= 1; y += 0.19) {
                    const dvec2 back =
                        kOptics.ndc(eye, kOptics.tangent(eye, {x, y}, channel), channel);
                    ASSERT_NEAR(back.x, x, 1e-12);
                    ASSERT_NEAR(back.y, y, 1e-12);
                }
            }
        }
    }
}

TEST(Dk2Optics, TheLensAxisIsTowardsTheNose) {
    EXPECT_NEAR(kOptics.ndc(Eye::left, {0, 0}).x, -0.009860, 1e-6);
    EXPECT_NEAR(kOptics.ndc(Eye::right, {0, 0}).x, 0.009860, 1e-6);
}

TEST(Dk2Optics, PixelsRunRightAndDown) {
    const auto top_left = kOptics.pixel_tangents(Eye::left, 0, 0);
    EXPECT_LT(top_left[1].x, -1);
    EXPECT_GT(top_left[1].y, 1);
    // Blue is bent most: its tangent at a panel place lies outside of green's, red's inside.
    EXPECT_LT(glm::length(top_left[0]), glm::length(top_left[1]));
    EXPECT_GT(glm::length(top_left[2]), glm::length(top_left[1]));
    const auto mirrored = kOptics.pixel_tangents(Eye::right, 959, 0);
    EXPECT_NEAR(mirrored[1].x, -top_left[1].x, 1e-12);
    EXPECT_NEAR(mirrored[1].y, top_left[1].y, 1e-12);
}

}  // namespace
}  // namespace foverig
