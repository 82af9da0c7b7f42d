// Fixes by hand, of a head that turns evenly; the bytes' way is in tests/simulators/camera.
#include "devices/fusion/tracked_head.h"

#include <gtest/gtest.h>

#include "tests/devices/fusion/turning_head.h"

namespace foverig {
namespace {

using test::host;
using test::kDeg;
using test::TurningHead;

constexpr dvec3 kRate_rad_s{0, 1, 0};
const RigidPose kWorldFromCamera{exp_map(dvec3(0.1, 0.4, 0)), dvec3(0.2, 0.3, -1.5)};

/// A head without levers, so that it only turns, and its camera.
class TrackedTurn : public testing::Test {
  protected:
    void run_to(double end_s) {
        while (head_.time_s + 0.0005 < end_s) {
            head_.go_to(head_.time_s + 0.001);
            tracked_.add(head_.sample());
        }
    }
    /// Nothing is heard of the sensor meanwhile.
    void skip_to(double end_s) { head_.go_to(end_s); }
    /// What the camera saw `age_s` ago comes now; it was moved by `aside_m` since it was placed.
    void fix(double age_s, double aside_m = 0) {
        const double taken_s = head_.time_s - age_s;
        const RigidPose world_from_imu{exp_map(kRate_rad_s * taken_s), dvec3(0)};
        PoseFix fix;
        fix.taken_device = Dk2Time(from_seconds(1000 + taken_s));
        fix.taken = host(taken_s);
        fix.arrival = host(head_.time_s);
        fix.camera_from_imu = kWorldFromCamera.inverse() * world_from_imu;
        fix.camera_from_imu.translation_m.x += aside_m;
        for (std::size_t i = 0; i < 6; ++i) fix.covariance(i, i) = 1e-6;
        tracked_.add(fix);
    }
    double error_deg() const {
        return angle_between(tracked_.at(host(head_.time_s)).world_from_head,
                             head_.world_from_head) /
               kDeg;
    }

    TurningHead head_{.rate_rad_s = [](double) { return kRate_rad_s; }};
    TrackedHead tracked_{{.inertial = {.initial_yaw_rad = 0.001 * kRate_rad_s.y,
                                       .eyes_from_neck_m = dvec3(0),
                                       .sensor_from_eyes_m = dvec3(0)},
                          .fixes_to_place_camera = 5}};
};

// A pose of 150 ms ago, taken for one of 100 ms ago, would put the camera 2.9 degrees aside.
TEST_F(TrackedTurn, PlacesTheCameraByNoFixThatIsOlderThanTheGyroTells) {
    run_to(0.5);
    for (int i = 0; i < 6; ++i) {
        run_to(head_.time_s + 0.016);
        fix(0.15);
    }
    EXPECT_FALSE(tracked_.world_from_camera());
    EXPECT_EQ(tracked_.counts().too_old, 6U);
    for (int i = 0; i < 5; ++i) {
        run_to(head_.time_s + 0.016);
        fix(0.095);
    }
    ASSERT_TRUE(tracked_.tracking());
    EXPECT_EQ(tracked_.counts().too_old, 6U);
    EXPECT_LT(angle_between(tracked_.world_from_camera()->rotation, kWorldFromCamera.rotation),
              0.05 * kDeg);
}

TEST_F(TrackedTurn, BeginsAgainAfterAGapWithAFixThatTheGyroReaches) {
    run_to(0.5);
    for (int i = 0; i < 5; ++i) {
        run_to(head_.time_s + 0.016);
        fix(0.03);
    }
    ASSERT_TRUE(tracked_.tracking());
    skip_to(head_.time_s + 0.4);
    run_to(head_.time_s + 0.2);
    ASSERT_FALSE(tracked_.tracking());
    fix(0.15);
    EXPECT_FALSE(tracked_.tracking());
    EXPECT_EQ(tracked_.counts().too_old, 1U);
    fix(0.03);
    ASSERT_TRUE(tracked_.tracking());
    run_to(head_.time_s + 0.5);  // until the correction is shown in full
    EXPECT_LT(error_deg(), 0.1);
}

TEST_F(TrackedTurn, CountsUnlikelyFixesThatItIsTooLateToBeginAgainWith) {
    run_to(0.5);
    for (int i = 0; i < 5; ++i) {
        run_to(head_.time_s + 0.016);
        fix(0.03);
    }
    ASSERT_TRUE(tracked_.tracking());
    run_to(head_.time_s + 0.2);  // until the filter keeps what it held 150 ms ago
    for (int i = 0; i < 16; ++i) {
        run_to(head_.time_s + 0.016);
        fix(0.15, 0.5);
    }
    EXPECT_EQ(tracked_.counts().unlikely, 16U);
    EXPECT_EQ(tracked_.counts().too_old, 2U) << "the fifteenth in a row would begin, and the next";
    EXPECT_EQ(tracked_.counts().restarts, 0U);
    run_to(head_.time_s + 0.016);
    fix(0.03, 0.5);
    EXPECT_EQ(tracked_.counts().restarts, 1U);
    EXPECT_EQ(tracked_.counts().too_old, 2U);
}

}  // namespace
}  // namespace foverig
