#include "simulators/motion/guided_eye.h"

#include <gtest/gtest.h>

namespace foverig::motion {
namespace {

double off_deg(const GuidedEye& eye, double t_s, const dvec2& target_deg) {
    return glm::distance(gaze_of(eye.at(t_s).direction), target_deg);
}

// DEVICES.md 5.1: latency 100 to 300 ms, undershoot 5 to 10 %, a correction 100 to 200 ms later.
TEST(GuidedEye, NoticesLateFallsShortAndCorrects) {
    GuidedEye eye(3);
    const dvec2 target(12.0, 5.0);
    eye.show(1.0, target);
    EXPECT_LT(off_deg(eye, 0.9, {0, 0}), 0.3);
    EXPECT_LT(off_deg(eye, 1.09, {0, 0}), 0.3) << "nobody is that quick";
    double landed_s = 0.0, corrected_s = 0.0;
    for (double t_s = 1.0; t_s < 2.0; t_s += 0.001) {
        if (landed_s == 0.0 && off_deg(eye, t_s, target) < 0.11 * 13.0) landed_s = t_s;
        if (corrected_s == 0.0 && off_deg(eye, t_s, target) < 0.3) corrected_s = t_s;
    }
    EXPECT_GT(landed_s, 1.1);
    EXPECT_LT(landed_s, 1.36);
    EXPECT_GT(corrected_s, landed_s + 0.1);
    EXPECT_LT(corrected_s, 1.6);
    EXPECT_LT(off_deg(eye, 5.0, target), 0.3) << "only drift is left";
}

TEST(GuidedEye, LeavesAnOldTargetForANewOne) {
    GuidedEye eye(3);
    eye.show(0.0, {10.0, 0.0});
    eye.show(0.1, {-10.0, 0.0});
    EXPECT_LT(off_deg(eye, 1.0, {-10.0, 0.0}), 0.3);
    for (double t_s = 0.5; t_s < 1.0; t_s += 0.01) {
        EXPECT_LT(gaze_of(eye.at(t_s).direction).x, -8.0) << "nothing is left of the first";
    }
}

}  // namespace
}  // namespace foverig::motion
