#include "devices/fusion/head_fusion.h"

#include <gtest/gtest.h>

#include "tests/devices/byte_text.h"
#include "tests/devices/fusion/turning_head.h"

namespace foverig {
namespace {

using namespace test;

HeadFusionConfig gyro_only() {
    HeadFusionConfig config;
    config.tilt_gain_per_s = 0;
    config.max_gravity_error_m_s2 = 0;  // no sample is near enough to gravity
    config.auto_bias = false;
    return config;
}

TEST(HeadFusion, ConstantRotationIsExact) {
    HeadFusion fusion(gyro_only());
    TurningHead head{[](double) { return dvec3(0.7, 2, -0.4); }};
    for (int i = 0; i <= 10000; ++i) {
        head.time_s = i * 1e-3;
        head.world_from_head = exp_map(head.rate_rad_s(0) * head.time_s);  // the analytic answer
        ImuSample s = head.sample();
        s.accel_m_s2 = kUpright_m_s2;
        fusion.add(s);
    }
    EXPECT_LT(error_deg(fusion, head), 1e-9);
    EXPECT_NEAR(glm::length(fusion.at(host(10)).world_from_head), 1, 1e-14);
}

TEST(HeadFusion, FollowsAConingHead) {
    HeadFusion fusion(gyro_only());
    // 5 Hz, 173 deg/s on two axes in quadrature: the stress profile of DEVICES.md 6.1, coning.
    TurningHead head{[](double t) {
        const double phase = 2 * std::numbers::pi * 5 * t;
        return 173 * kDeg * dvec3(std::cos(phase), std::sin(phase), 0.2);
    }};
    for (int i = 0; i <= 20000; ++i) {
        head.go_to(i * 1e-3);
        ImuSample s = head.sample();
        if (i == 0) s.accel_m_s2 = kUpright_m_s2;
        fusion.add(s);
    }
    // Straight lines between 1 kHz samples lose (2 pi 5 Hz)^2 (1 ms)^2 / 6 of a cone that drifts
    // 8.3 deg/s: 0.027 degrees in 20 s.
    EXPECT_LT(error_deg(fusion, head), 0.03);
}

TEST(HeadFusion, AGapIsBridgedWithTheLastRate) {
    HeadFusion fusion(gyro_only());
    TurningHead head{[](double t) { return dvec3(0, 1 + 0.5 * t, 0); }};
    for (int i = 0; i <= 2000; ++i) {
        head.go_to(i * 1e-3);
        ImuSample s = head.sample();
        if (i == 0) s.accel_m_s2 = kUpright_m_s2;
        if (i > 1000 && i < 1100) continue;
        s.gap = i == 1100;
        fusion.add(s);
    }
    // Rate grows 0.5 rad/s^2 over 100 ms: the last rate misses half of 0.05 rad/s * 0.1 s.
    EXPECT_NEAR(error_deg(fusion, head), 0.0025 / kDeg, 0.01);
    EXPECT_FALSE(fusion.at(host(2)).stale);
}

TEST(HeadFusion, IgnoresSamplesThatAreNotLater) {
    HeadFusion fusion(gyro_only());
    ImuSample s;
    s.accel_m_s2 = kUpright_m_s2;
    s.gyro_rad_s = {0, 5, 0};
    s.device_time = Dk2Time(Nanoseconds{5'000'000});
    fusion.add(s);
    fusion.add(s);
    s.device_time = Dk2Time(Nanoseconds{4'000'000});
    fusion.add(s);
    EXPECT_EQ(fusion.at(s.host_time).world_from_head, dquat(1, 0, 0, 0));
}

TEST(HeadFusion, TheEyesMoveAboutTheNeck) {
    HeadFusion fusion;
    TurningHead head{[](double) { return dvec3(0); }};
    fusion.add(head.sample());
    EXPECT_EQ(fusion.at(host(0)).position_m, dvec3(0));
    HeadFusion nodding;
    head.world_from_head = exp_map(dvec3(-90 * kDeg, 0, 0));  // looking at the floor
    nodding.add(head.sample());
    // Eyes 0.0805 ahead and 0.075 above the neck swing down: ahead by 0.075 and below by 0.0805.
    const dvec3 moved = nodding.at(host(0)).position_m;
    EXPECT_NEAR(moved.y, -0.0805 - 0.075, 1e-9);
    EXPECT_NEAR(moved.z, -0.075 + 0.0805, 1e-9);
    EXPECT_NEAR(moved.x, 0, 1e-12);
}

double worst_prediction_deg(Predictor predictor, double ahead_s, double noise_rad_s) {
    HeadFusionConfig config = gyro_only();
    config.predictor = predictor;
    HeadFusion fusion(config);
    test::Random random(7);
    // 2 Hz, +-15.5 degrees about y: 195 deg/s, 2450 deg/s^2 (DEVICES.md 6.1).
    const double w = 2 * std::numbers::pi * 2;
    const auto yaw = [&](double t) { return 15.5 * kDeg * std::sin(w * t); };
    double worst = 0;
    for (int i = 0; i < 3000; ++i) {
        const double t = i * 1e-3;
        ImuSample s;
        s.host_time = host(t);
        s.device_time = Dk2Time(from_seconds(t));
        s.gyro_rad_s = {
            0, 15.5 * kDeg * w * std::cos(w * t) + noise_rad_s * 3.4641 * (random.uniform() - 0.5),
            0};
        s.accel_m_s2 = kUpright_m_s2;
        fusion.add(s);
        if (i < 100) continue;
        const dquat truth = exp_map(dvec3(0, yaw(t + ahead_s), 0));
        worst = std::max(worst,
                         angle_between(fusion.at(host(t + ahead_s)).world_from_head, truth) / kDeg);
    }
    return worst;
}

TEST(HeadFusion, PredictionErrorIsThatOfItsOrder) {
    // The first neglected term: rate * t, acceleration * t^2 / 2, jerk * t^3 / 6.
    const double t = 0.025, w = 2 * std::numbers::pi * 2;
    const double rate = 15.5 * w, acceleration = rate * w, jerk = acceleration * w;
    EXPECT_NEAR(worst_prediction_deg(Predictor::none, t, 0), rate * t, 0.1);
    EXPECT_NEAR(worst_prediction_deg(Predictor::constant_rate, t, 0), acceleration * t * t / 2,
                0.05);
    // The slope lags by half its 12 samples: jerk * 5.5 ms * t^2 / 2 more.
    EXPECT_LT(worst_prediction_deg(Predictor::constant_acceleration, t, 0),
              1.1 * (jerk * t * t * t / 6 + jerk * 0.0055 * t * t / 2));
}

TEST(HeadFusion, ConstantAccelerationIsBetterThroughTheSensorsNoise) {
    const double rate = worst_prediction_deg(Predictor::constant_rate, 0.025, 3.1e-3);
    const double acceleration =
        worst_prediction_deg(Predictor::constant_acceleration, 0.025, 3.1e-3);
    EXPECT_LT(acceleration, 0.5 * rate);
}

}  // namespace
}  // namespace foverig
