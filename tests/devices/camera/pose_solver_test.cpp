#include "devices/camera/pose_solver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "devices/fusion/rotation.h"
#include "simulators/motion/random.h"

namespace foverig::camera {
namespace {

const Lens kLens{.k1 = -0.2, .k2 = 0.05, .p1 = 0.0005};
const RigidPose kTruth{exp_map({0.3, 2.9, -0.2}), {0.05, -0.03, 0.9}};

std::vector<Correspondence> seen(double noise_px, std::uint64_t seed, std::size_t outliers = 0) {
    const motion::Draws draws(seed, 1);
    std::vector<Correspondence> points;
    for (std::uint64_t i = 0; i < 18; ++i) {
        const dvec3 point(draws.uniform(10 * i, -0.09, 0.09),
                          draws.uniform(10 * i + 1, -0.05, 0.05),
                          draws.uniform(10 * i + 2, -0.02, 0.05));
        dvec2 pixel = *kLens.project(kTruth * point);
        pixel += noise_px * dvec2(draws.normal(10 * i + 3), draws.normal(10 * i + 4));
        if (i < outliers) pixel += dvec2(40, -25) + 10.0 * dvec2(draws.normal(10 * i + 5), i);
        points.push_back({point, pixel});
    }
    return points;
}

struct Off {
    dvec3 turn_rad{0}, way_m{0};
};
Off off(const SolvedPose& pose) {
    return {log_map(glm::conjugate(kTruth.rotation) * pose.camera_from_imu.rotation),
            pose.camera_from_imu.translation_m - kTruth.translation_m};
}

TEST(PoseSolver, FindsTheExactPoseFromNothing) {
    const auto pose = solve_pose(seen(0, 1), kLens);
    ASSERT_TRUE(pose);
    EXPECT_LT(glm::length(off(*pose).way_m), 1e-6);
    EXPECT_LT(glm::length(off(*pose).turn_rad), 1e-5);
    EXPECT_EQ(pose->inliers.size(), 18u);
    EXPECT_LT(pose->rms_px, 1e-3);
}

TEST(PoseSolver, LeavesOutliersOut) {
    const auto pose = solve_pose(seen(0.05, 2, 5), kLens);
    ASSERT_TRUE(pose);
    EXPECT_EQ(pose->inliers.size(), 13u);
    for (const std::size_t i : pose->inliers) EXPECT_GE(i, 5u);
    EXPECT_LT(glm::length(off(*pose).way_m), 1e-3);
}

TEST(PoseSolver, RefinesAGuessThatIsAFewDegreesOff) {
    const RigidPose guess{kTruth.rotation * exp_map({0.05, -0.05, 0.03}),
                          kTruth.translation_m + dvec3(0.005, -0.005, 0.02)};
    const auto pose = refine_pose(seen(0, 3), kLens, guess);
    ASSERT_TRUE(pose);
    EXPECT_LT(glm::length(off(*pose).way_m), 1e-6);
}

TEST(PoseSolver, GivesNothingOfTooLittleOrOfNonsense) {
    auto points = seen(0, 4);
    EXPECT_FALSE(solve_pose(std::span(points).first(4), kLens));
    EXPECT_FALSE(solve_pose(std::span(points).first(0), kLens));
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i].pixel = {37.0 * static_cast<double>(i * i % 19),
                           23.0 * static_cast<double>(i * 7 % 17)};
    }
    const auto pose = solve_pose(points, kLens);
    EXPECT_TRUE(!pose || pose->inliers.size() < 9);
}

// The scatter of 400 solutions against the covariance that each of them claims.
TEST(PoseSolver, KnowsItsOwnUncertainty) {
    constexpr int kRuns = 400;
    double turns = 0, ways = 0, claimed_turns = 0, claimed_ways = 0;
    for (int i = 0; i < kRuns; ++i) {
        const auto pose =
            refine_pose(seen(0.2, 100 + static_cast<std::uint64_t>(i)), kLens, kTruth);
        ASSERT_TRUE(pose);
        const Off error = off(*pose);
        turns += glm::dot(error.turn_rad, error.turn_rad);
        ways += glm::dot(error.way_m, error.way_m);
        for (std::size_t k = 0; k < 3; ++k) {
            claimed_turns += pose->covariance(k, k);
            claimed_ways += pose->covariance(k + 3, k + 3);
        }
    }
    EXPECT_NEAR(std::sqrt(turns / claimed_turns), 1.0, 0.15);
    EXPECT_NEAR(std::sqrt(ways / claimed_ways), 1.0, 0.15);
}

}  // namespace
}  // namespace foverig::camera
