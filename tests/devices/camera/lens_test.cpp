#include "devices/camera/lens.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <opencv2/calib3d.hpp>

namespace foverig::camera {
namespace {

const Lens kOdd{693.5, 691.25, 360.5, 250.75, -0.33, 0.12, 0.001, -0.0005, -0.01};

// Offsets of DEVICES.md 1.8.4, which two sources agree on.
TEST(LensBlock, HoldsItsNumbersWhereTheDeviceDoes) {
    const auto block = encode_lens_block(kOdd);
    ASSERT_EQ(block.size(), 122u);
    EXPECT_EQ(read_u32(block, 0), 0xE2978900u);
    EXPECT_EQ(read_u16(block, 4), 122);
    EXPECT_EQ(read_u16(block, 6), 1);
    EXPECT_EQ(read_u16(block, 8), 9);
    const std::array<std::pair<std::size_t, double>, 9> places{{{18, 693.5},
                                                                {30, 691.25},
                                                                {42, 360.5},
                                                                {54, 250.75},
                                                                {66, -0.33},
                                                                {78, 0.12},
                                                                {90, 0.001},
                                                                {102, -0.0005},
                                                                {114, -0.01}}};
    for (const auto& [at, value] : places) {
        EXPECT_EQ(std::bit_cast<double>(read_u64(block, at)), value) << at;
    }
    EXPECT_EQ(decode_lens_block(block).value(), kOdd);
}

TEST(LensBlock, IsRefusedWhereItIsNoneOrHoldsNoNumber) {
    const auto block = encode_lens_block(kOdd);
    EXPECT_FALSE(decode_lens_block(Bytes(block).first(121)));
    for (const std::size_t at : {0u, 4u, 6u, 8u, 16u, 112u}) {
        auto bad = block;
        bad[at] ^= std::byte{1};
        EXPECT_FALSE(decode_lens_block(bad)) << at;
    }
    for (const double value : {std::nan(""), HUGE_VAL, 0.0, -500.0}) {
        auto bad = block;
        write_u64(bad, 18, std::bit_cast<std::uint64_t>(value));
        EXPECT_FALSE(decode_lens_block(bad)) << value;
    }
    EXPECT_FALSE(decode_lens_block(std::vector<std::byte>(122, std::byte{0xFF})));
}

TEST(Lens, SeesTheDesignsSeventyDegrees) {
    const double edge = std::tan(35.0 * 3.14159265358979 / 180.0);
    EXPECT_NEAR(Lens{}.project({edge, 0, 1}).value().x, 751.5, 0.01);
    EXPECT_EQ(Lens{}.project({0, 0, 2}).value(), dvec2(375.5, 239.5));
    EXPECT_FALSE(Lens{}.project({0, 0, -1}));
    EXPECT_FALSE(Lens{}.project({0, 0, 0}));
}

constexpr Lens kWide{420.0, 415.0, 330.0, 236.0, -0.28, 0.09, 0.0012, -0.0007, -0.012};

/// OpenCV's calib3d, another's code for the same formulas.
struct OpenCv {
    cv::Matx33d camera;
    std::vector<double> bend;
    explicit OpenCv(const Lens& l)
        : camera(l.fx_px, 0, l.cx_px, 0, l.fy_px, l.cy_px, 0, 0, 1),
          bend{l.k1, l.k2, l.p1, l.p2, l.k3} {}
};

TEST(Lens, ProjectsAsOpenCvDoes) {
    for (const Lens& lens : {Lens{}, kWide, Lens{.k1 = 0.15, .k2 = -0.02, .p2 = 0.002}}) {
        std::vector<cv::Point3d> points;
        for (double x = -0.8; x <= 0.8; x += 0.2)
            for (double y = -0.6; y <= 0.6; y += 0.2) points.emplace_back(2 * x, 2 * y, 2.0);
        std::vector<cv::Point2d> expected;
        const OpenCv theirs(lens);
        const cv::Vec3d none(0, 0, 0);
        cv::projectPoints(points, none, none, theirs.camera, theirs.bend, expected);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const dvec2 ours = lens.project({points[i].x, points[i].y, points[i].z}).value();
            EXPECT_NEAR(ours.x, expected[i].x, 1e-9);
            EXPECT_NEAR(ours.y, expected[i].y, 1e-9);
        }
    }
}

TEST(Lens, UndistortsAsOpenCvDoes) {
    for (const Lens& lens : {Lens{}, kWide, Lens{.k1 = 0.15, .k2 = -0.02, .p2 = 0.002}}) {
        std::vector<cv::Point2d> pixels, expected;
        for (double x = 0; x < 640; x += 53)
            for (double y = 0; y < 480; y += 53) pixels.emplace_back(x, y);
        const OpenCv theirs(lens);
        const cv::TermCriteria exact(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 400, 1e-12);
        cv::undistortPoints(pixels, expected, theirs.camera, theirs.bend, cv::noArray(),
                            cv::noArray(), exact);
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const dvec3 ours = lens.ray_at({pixels[i].x, pixels[i].y}).value();
            EXPECT_NEAR(ours.x, expected[i].x, 1e-7);
            EXPECT_NEAR(ours.y, expected[i].y, 1e-7);
        }
    }
}

TEST(Lens, FoldsWhereItsRadiusStopsGrowing) {
    EXPECT_EQ(Lens{}.fold_tangent(), HUGE_VAL);
    EXPECT_EQ(Lens{.k1 = 0.2}.fold_tangent(), HUGE_VAL);
    // 1 + 3 k1 r^2 = 0, and 1 + 3 k1 r^2 + 5 k2 r^4 = 0 at its first root.
    EXPECT_NEAR(Lens{.k1 = -0.3}.fold_tangent(), std::sqrt(1 / 0.9), 1e-9);
    const Lens ghost{.k1 = -0.4, .k2 = 0.05};
    EXPECT_NEAR(ghost.fold_tangent(), std::sqrt((1.2 - std::sqrt(1.2 * 1.2 - 1.0)) / 0.5), 1e-9);
    EXPECT_FALSE(ghost.ray_at({ghost.cx_px + 5000, ghost.cy_px})) << "no ray falls there";
}

// Barrel distortion turns back on itself far out, where a second point would fall on each pixel.
TEST(Lens, HasNoPixelWhereItsDistortionFoldsBack) {
    const Lens barrel{.k1 = -0.3};
    EXPECT_TRUE(barrel.project({0.9, 0, 1}));
    EXPECT_FALSE(barrel.project({1.2, 0, 1}));
}

}  // namespace
}  // namespace foverig::camera
