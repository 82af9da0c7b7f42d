#include "simulators/motion/pointed_eye.h"

#include <gtest/gtest.h>

namespace foverig::motion {
namespace {

TEST(PointedEye, LooksWhereItWasLastTold) {
    PointedEye eye;
    EXPECT_EQ(eye.at(5.0).direction, dvec3(0.0, 0.0, -1.0)) << "straight ahead at first";
    eye.look(1.0, {.direction = direction_of({10.0, 0.0})});
    eye.look(2.0, {.direction = direction_of({0.0, -5.0}), .vergence_m = 0.5});
    EXPECT_EQ(eye.at(0.9).direction, dvec3(0.0, 0.0, -1.0));
    EXPECT_NEAR(gaze_of(eye.at(1.5).direction).x, 10.0, 1e-9);
    EXPECT_NEAR(gaze_of(eye.at(2.0).direction).y, -5.0, 1e-9);
    EXPECT_EQ(eye.at(100.0).vergence_m, 0.5);
}

TEST(PointedEye, ForgetsWhatNobodyAsksForAnyMore) {
    PointedEye eye;
    for (std::size_t i = 0; i <= PointedEye::kHistory; ++i)
        eye.look(static_cast<double>(i), {.vergence_m = static_cast<double>(i)});
    EXPECT_EQ(eye.at(1.0).vergence_m, 1.0);
    EXPECT_EQ(eye.at(0.5).vergence_m, EyeState{}.vergence_m);
}

}  // namespace
}  // namespace foverig::motion
