#include "devices/gaze/calibration_targets.h"

#include <gtest/gtest.h>

#include "devices/gaze/requests.h"

namespace foverig::gaze {
namespace {

// The places that DEVICES.md 4.5.6 lists.
TEST(CalibrationTargets, AreTheTablesPoints) {
    for (const int points : kCalibrationPoints) {
        EXPECT_EQ(default_points(points).size(), static_cast<std::size_t>(points));
        if (points > 0) {
            EXPECT_EQ(default_points(points).front(), dvec2(0.5, 0.5));
        }
    }
    EXPECT_TRUE(default_points(2).empty());
    EXPECT_EQ(default_points(3)[1], dvec2(0.25, 0.35));
    EXPECT_EQ(default_points(3)[2], dvec2(0.75, 0.65));
    EXPECT_EQ(default_points(5)[1], dvec2(0.2, 0.2));
    EXPECT_EQ(default_points(5)[4], dvec2(0.8, 0.8));
    const auto nine = default_points(9), thirteen = default_points(13);
    EXPECT_EQ(nine[1], dvec2(0.2, 0.2));
    EXPECT_EQ(nine[8], dvec2(0.8, 0.8));
    EXPECT_TRUE(std::equal(nine.begin(), nine.end(), thirteen.begin()));
    EXPECT_EQ(thirteen[9], dvec2(0.35, 0.35));
    EXPECT_EQ(thirteen[12], dvec2(0.65, 0.65));
}

TEST(CalibrationTargets, ReachAsFarAsAsked) {
    EXPECT_EQ(targets_deg(1, 16.0)[0], dvec2(0.0, 0.0));
    const auto five = targets_deg(5, 16.0);
    EXPECT_NEAR(five[1].x, -16.0, 1e-12) << "left";
    EXPECT_NEAR(five[1].y, 16.0, 1e-12) << "top";
    EXPECT_NEAR(targets_deg(13, 16.0)[12].x, 8.0, 1e-12);
}

// 2.2: the frustum's tangents are 1.058657 temporal, 1.092368 nasal, 1.331603 up and down.
TEST(CalibrationTargets, AreWhereTheFrustumPutsThem) {
    EXPECT_NEAR(por_of({0.0, 0.0})[0], 480.0, 1e-3);
    EXPECT_NEAR(por_of({0.0, 0.0})[1], 540.0, 1e-3);
    const double right_deg = glm::degrees(std::atan(0.5 * (1.058657 + 1.092368)));
    EXPECT_NEAR(por_of({right_deg, 0.0})[0], 960.0, 1e-2);
    EXPECT_NEAR(por_of({0.0, glm::degrees(std::atan(1.331603))})[1], 0.0, 1e-2);
    for (const dvec2& target : targets_deg(13, 16.0)) {
        EXPECT_LT(glm::distance(target_deg_of(por_of(target)), target), 1e-4);
    }
}

}  // namespace
}  // namespace foverig::gaze
