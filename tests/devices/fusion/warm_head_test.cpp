// A chip that warms while the camera sees the head, and goes on warming when it does not.
#include <gtest/gtest.h>

#include "devices/fusion/tracked_head.h"
#include "tests/devices/fusion/turning_head.h"

namespace foverig {
namespace {

using namespace test;

constexpr double kSeen_s = 60, kHidden_s = 30;
constexpr double kSlope_deg_s_c = 0.05, kWarming_c_s = 0.1;

/// The head rests before a camera and then swings unseen. The sensor is at the pivot.
double yaw_lost_deg(double slope_sigma_rad_s_c) {
    TrackedHeadConfig config;
    config.inertial.bias.slope_sigma_rad_s_c = slope_sigma_rad_s_c;
    config.inertial.eyes_from_neck_m = config.inertial.sensor_from_eyes_m = dvec3(0);
    TrackedHead tracked(config);
    TurningHead head{[](double t) {
        return t < kSeen_s ? dvec3(0) : dvec3(0, 0.8 * std::sin(2 * (t - kSeen_s)), 0);
    }};
    Matrix<6, 6> covariance = Matrix<6, 6>::identity();
    covariance *= 1e-6;
    for (int ms = 0; ms <= static_cast<int>(1000 * (kSeen_s + kHidden_s)); ++ms) {
        head.go_to(1e-3 * ms);
        ImuSample sample = head.sample();
        sample.temperature_c = 25 + kWarming_c_s * head.time_s;
        sample.gyro_rad_s += dvec3(0, 0.1 + kSlope_deg_s_c * (sample.temperature_c - 25), 0) * kDeg;
        tracked.add(sample);
        if (head.time_s > kSeen_s || ms % 16 != 0 || ms < 16) continue;
        const Nanoseconds age{2'500'000};  // in it the head rests
        PoseFix fix;
        fix.taken_device = sample.device_time - age;
        fix.taken = sample.host_time - age;
        fix.arrival = sample.host_time;
        fix.camera_from_imu = {head.world_from_head, dvec3(0)};
        fix.covariance = covariance;
        tracked.add(fix);
    }
    EXPECT_GT(tracked.counts().fixes, 3000u);
    const dquat error =
        tracked.at(host(head.time_s)).world_from_head * glm::conjugate(head.world_from_head);
    return glm::length(log_map(error)) / kDeg;
}

// Hidden, the bias moves on by 0.05 * 0.1 deg/s each second: 2.25 degrees after 30 s. Where the
// slope is not known the fixes' bias is late as well.
TEST(WarmHead, TheFixesBiasMovesOnWithTheTemperature) {
    const double by_slope_deg = 0.5 * kSlope_deg_s_c * kWarming_c_s * kHidden_s * kHidden_s;
    EXPECT_GT(yaw_lost_deg(0), by_slope_deg);
    EXPECT_LT(yaw_lost_deg(GyroBiasConfig{}.slope_sigma_rad_s_c), 0.1 * by_slope_deg);
}

}  // namespace
}  // namespace foverig
