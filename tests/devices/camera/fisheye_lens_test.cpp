#include "devices/camera/fisheye_lens.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <opencv2/calib3d.hpp>

namespace foverig::camera {
namespace {

constexpr FisheyeLens::Numbers kUsual{
    284.0, 285.5, 321.0, 237.0, {-0.0081, 0.0412, -0.0389, 0.0072}};

/// OpenCV's calib3d, another's code for the same model.
struct OpenCv {
    cv::Matx33d camera;
    cv::Vec4d bend;
    explicit OpenCv(const FisheyeLens::Numbers& n)
        : camera(n.fx_px, 0, n.cx_px, 0, n.fy_px, n.cy_px, 0, 0, 1),
          bend(n.k[0], n.k[1], n.k[2], n.k[3]) {}
};

TEST(FisheyeLens, ProjectsAsOpenCvDoes) {
    std::vector<cv::Point3d> points;
    for (double x = -3; x <= 3; x += 0.75)
        for (double y = -2; y <= 2; y += 0.5) points.emplace_back(x, y, 1.5);
    std::vector<cv::Point2d> expected;
    const OpenCv theirs(kUsual);
    const cv::Vec3d none(0, 0, 0);
    cv::fisheye::projectPoints(points, expected, none, none, theirs.camera, theirs.bend);
    const FisheyeLens lens(kUsual);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const dvec2 ours = lens.project({points[i].x, points[i].y, points[i].z}).value();
        EXPECT_NEAR(ours.x, expected[i].x, 1e-9);
        EXPECT_NEAR(ours.y, expected[i].y, 1e-9);
    }
}

TEST(FisheyeLens, UndistortsAsOpenCvDoes) {
    std::vector<cv::Point2d> pixels, expected;
    for (double x = 5; x < 640; x += 53)
        for (double y = 5; y < 480; y += 53) pixels.emplace_back(x, y);
    const OpenCv theirs(kUsual);
    const cv::TermCriteria exact(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 100, 1e-14);
    cv::fisheye::undistortPoints(pixels, expected, theirs.camera, theirs.bend, cv::noArray(),
                                 cv::noArray(), exact);
    const FisheyeLens lens(kUsual);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const dvec3 ours = lens.ray_at({pixels[i].x, pixels[i].y}).value();
        EXPECT_NEAR(glm::length(ours), 1.0, 1e-12);
        EXPECT_NEAR(ours.x / ours.z, expected[i].x, 1e-7);
        EXPECT_NEAR(ours.y / ours.z, expected[i].y, 1e-7);
    }
}

// Without a polynomial the place is the angle itself, also beyond a quarter turn.
TEST(FisheyeLens, SeesBehindItsPlane) {
    const FisheyeLens lens({.fx_px = 100, .fy_px = 100, .cx_px = 320, .cy_px = 240});
    EXPECT_EQ(lens.fold_rad(), std::numbers::pi);
    for (const double deg : {1.0, 60.0, 90.0, 120.0, 179.0}) {
        const double rad = glm::radians(deg);
        const dvec2 at = lens.project({2 * std::sin(rad), 0, 2 * std::cos(rad)}).value();
        EXPECT_NEAR(at.x, 320 + 100 * rad, 1e-9);
        EXPECT_NEAR(at.y, 240, 1e-9);
        EXPECT_NEAR(lens.ray_at(at)->z, std::cos(rad), 1e-9);
    }
    EXPECT_EQ(lens.project({0, 0, 3}), dvec2(320, 240));
    EXPECT_EQ(lens.ray_at({320, 240}), dvec3(0, 0, 1));
    EXPECT_FALSE(lens.project({0, 0, -1})) << "straight behind: a ring, no place";
    EXPECT_FALSE(lens.project({0, 0, 0}));
    EXPECT_FALSE(lens.ray_at({320 + 315, 240})) << "more than half a turn";
}

TEST(FisheyeLens, FoldsWhereItsRadiusStopsGrowing) {
    const FisheyeLens lens({.k = {-0.1, 0, 0, 0}});  // 1 - 0.3 a^2 = 0
    EXPECT_NEAR(lens.fold_rad(), std::sqrt(1 / 0.3), 1e-9);
    const double fold = lens.fold_rad();
    const auto at = [](double rad) { return dvec3(std::sin(rad), 0, std::cos(rad)); };
    EXPECT_TRUE(lens.project(at(fold - 1e-3)));
    EXPECT_FALSE(lens.project(at(fold + 1e-3)));
    const double edge_px = lens.project(at(fold))->x;
    EXPECT_NEAR(edge_px, fold * (1 - 0.1 * fold * fold), 1e-12);
    EXPECT_FALSE(lens.ray_at({edge_px + 1e-6, 0}));
    EXPECT_NEAR(lens.ray_at({edge_px - 1e-6, 0})->x, std::sin(fold), 2e-3);
}

}  // namespace
}  // namespace foverig::camera
