#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "simulators/motion/catalog.h"
#include "simulators/motion/look_head.h"
#include "simulators/motion/simple_heads.h"

namespace foverig::motion {
namespace {

double angle_rad(const dquat& a, const dquat& b) {
    const dquat d = glm::conjugate(a) * b;
    return 2.0 * std::atan2(std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z), std::abs(d.w));
}

std::unique_ptr<HeadMotion> head(const std::string& name) {
    auto made = make_head(name, 11);
    EXPECT_TRUE(made) << name;
    return std::move(made).value();
}

/// Classical Runge-Kutta on q' = q (0, w) / 2 with the model's own body rates.
dquat integrated(const HeadMotion& motion, double from_s, double to_s, double step_s) {
    const auto slope = [&](const dquat& q, double t) {
        const dvec3 w = motion.at(t).angular_velocity_rad_s;
        return 0.5 * (q * dquat(0.0, w.x, w.y, w.z));
    };
    dquat q = motion.at(from_s).world_from_head;
    const int steps = static_cast<int>(std::lround((to_s - from_s) / step_s));
    for (int i = 0; i < steps; ++i) {
        const double t = from_s + i * step_s;
        const dquat k1 = slope(q, t), k2 = slope(q + 0.5 * step_s * k1, t + 0.5 * step_s);
        const dquat k3 = slope(q + 0.5 * step_s * k2, t + 0.5 * step_s);
        const dquat k4 = slope(q + step_s * k3, t + step_s);
        q = glm::normalize(q + step_s / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4));
    }
    return q;
}

class EveryHead : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Models, EveryHead,
                         testing::Values("still", "look", "stress", "extreme", "step"));

TEST_P(EveryHead, IntegratedRateIsTheOrientation) {
    const auto motion = head(GetParam());
    const dquat end = integrated(*motion, 0.0, 20.0, 1e-3);
    EXPECT_LT(angle_rad(end, motion->at(20.0).world_from_head), 1e-6);
}

TEST_P(EveryHead, AccelerationsAreTheDerivatives) {
    const auto motion = head(GetParam());
    constexpr double kH = 1e-4;
    for (double t = 0.513; t < 8.0; t += 0.317) {
        const HeadState a = motion->at(t - kH), b = motion->at(t), c = motion->at(t + kH);
        const dvec3 alpha = (c.angular_velocity_rad_s - a.angular_velocity_rad_s) / (2.0 * kH);
        const dvec3 linear = (c.position_m - 2.0 * b.position_m + a.position_m) / (kH * kH);
        EXPECT_LT(glm::distance(alpha, b.angular_acceleration_rad_s2), 0.02) << t;
        EXPECT_LT(glm::distance(linear, b.acceleration_m_s2), 0.01) << t;
    }
}

TEST_P(EveryHead, IsAPureFunctionOfTimeAndSeed) {
    const auto a = head(GetParam()), b = head(GetParam());
    const HeadState later = a->at(7.25);
    (void)a->at(1.0);
    EXPECT_EQ(a->at(7.25).world_from_head, later.world_from_head);
    EXPECT_EQ(b->at(7.25).world_from_head, later.world_from_head);
}

TEST(StillHead, FeelsOnlyGravityUpwards) {
    const dvec3 force = specific_force(StillHead().at(3.0), dvec3(0.1, -0.2, 0.3), 9.80665);
    EXPECT_EQ(force, dvec3(0.0, 9.80665, 0.0));
}

TEST(HeadState, LeansGravityIntoTheHeadFrame) {
    // Nose up by 30 degrees: gravity's reaction keeps pointing to the sky, which is now partly
    // ahead (-z) of the head.
    const HeadState nodding = head_from_angles({}, {glm::radians(30.0), 0.0, 0.0}, {});
    const dvec3 force = specific_force(nodding, dvec3(0.0), 10.0);
    EXPECT_NEAR(force.y, 10.0 * std::cos(glm::radians(30.0)), 1e-12);
    EXPECT_NEAR(force.z, -5.0, 1e-12);
}

TEST(HeadState, PullsALeverInwardsWhenTurning) {
    // Steady turn at 10 rad/s, 0.1 m to the right: 10 m/s^2 towards the centre.
    HeadState turning;
    turning.angular_velocity_rad_s = {0.0, 10.0, 0.0};
    const dvec3 force = specific_force(turning, dvec3(0.1, 0.0, 0.0), 0.0);
    EXPECT_NEAR(force.x, -10.0, 1e-12);
    EXPECT_NEAR(glm::length(force), 10.0, 1e-12);
}

// DEVICES.md 6.1: 5 Hz +-5.5 deg is 173 deg/s and 5430 deg/s^2; +-11 deg is 346 and 10 860.
TEST(ShakeHead, ReachesTheDocumentedPeaks) {
    const auto peaks = [](const HeadMotion& motion) {
        double rate = 0, acceleration = 0;
        for (double t = 1.6; t < 2.0; t += 1e-4) {
            const HeadState s = motion.at(t);
            rate = std::max(rate, glm::length(s.angular_velocity_rad_s));
            acceleration = std::max(acceleration, glm::length(s.angular_acceleration_rad_s2));
        }
        return dvec2(glm::degrees(rate), glm::degrees(acceleration));
    };
    EXPECT_NEAR(peaks(*head("stress")).x, 173.0, 0.5);
    EXPECT_NEAR(peaks(*head("stress")).y, 5430.0, 5.0);
    EXPECT_NEAR(peaks(*head("extreme")).x, 346.0, 1.0);
    EXPECT_NEAR(peaks(*head("extreme")).y, 10860.0, 10.0);
}

TEST(ShakeHead, KnocksWithSixGAndComesBack) {
    const ShakeHead calm(ShakeHead::Settings{.amplitude_deg = 0.0});
    const ShakeHead knocked(
        ShakeHead::Settings{.amplitude_deg = 0.0, .knock_peak_g = 6.0, .knock_time_s = 1.0});
    EXPECT_NEAR(std::abs(knocked.at(1.0).acceleration_m_s2.x), 6.0 * 9.80665, 1e-9);
    EXPECT_EQ(knocked.at(1.003).position_m, calm.at(1.003).position_m);
    double velocity = 0.0;
    for (double t = 0.99; t < 1.01; t += 1e-6) velocity += 1e-6 * knocked.at(t).acceleration_m_s2.x;
    EXPECT_NEAR(velocity, 0.0, 1e-6);
}

TEST(StepHead, TurnsOnceByItsAmplitude) {
    const StepHead step({.start_s = 0.5, .amplitude_deg = 10.0, .duration_s = 0.1});
    EXPECT_EQ(step.at(0.5).world_from_head, dquat(1, 0, 0, 0));
    EXPECT_NEAR(glm::degrees(angle_rad(step.at(0.0).world_from_head, step.at(0.6).world_from_head)),
                10.0, 1e-9);
    // Flash and Hogan's polynomial is half way, at 1.875 times the mean speed, in the middle.
    EXPECT_NEAR(glm::degrees(step.at(0.55).angular_velocity_rad_s.y), 187.5, 1e-9);
}

TEST(LookHead, ShiftsFollowTheDocumentedLaw) {
    const LookHead look(3);
    int above_median = 0, n = 0;
    for (const auto& shift : look.shifts()) {
        if (&shift == &look.shifts().back()) break;
        const double amplitude_deg = std::abs(shift.amplitude_deg[0]);
        above_median += amplitude_deg > 25.0 ? 1 : 0;
        ++n;
        const double peak_deg_s = 1.875 * amplitude_deg / shift.duration_s;
        EXPECT_NEAR(peak_deg_s, std::min(350.0, 4.5 * std::pow(amplitude_deg, 0.9)), 1e-9);
        EXPECT_NEAR(std::abs(shift.amplitude_deg[1]), 0.40 * amplitude_deg, 1e-9);
        EXPECT_NEAR(std::abs(shift.amplitude_deg[2]), 0.15 * amplitude_deg, 1e-9);
    }
    EXPECT_GT(n, 300);
    EXPECT_NEAR(above_median / static_cast<double>(n), 0.5, 3.0 * 0.5 / std::sqrt(n));
}

TEST(LookHead, NoiseIsTwoDegreesPerSecondBetweenShifts) {
    LookHead::Settings calm;
    calm.amplitude_median_deg = 1e-9;  // clamps to 1 degree: nearly no shifts
    double square = 0.0;
    int n = 0;
    const LookHead look(4, calm);
    for (const auto& shift : look.shifts()) {
        const double rate = glm::degrees(look.at(shift.start_s - 0.1).angular_velocity_rad_s.y);
        square += rate * rate;
        ++n;
    }
    EXPECT_NEAR(std::sqrt(square / n), 2.0, 0.25);
}

TEST(LookHead, KeepsANecksRangeAndClosesItsCycle) {
    LookHead::Settings quiet;
    quiet.noise_rms_deg_s = 0.0;
    const LookHead look(5, quiet);
    for (double t = 0.0; t < LookHead::kCycle_s; t += 0.25) {
        EXPECT_LT(angle_rad(look.at(t).world_from_head, dquat(1, 0, 0, 0)), glm::radians(130.0));
    }
    EXPECT_LT(angle_rad(look.at(LookHead::kCycle_s - 1e-6).world_from_head,
                        look.at(LookHead::kCycle_s).world_from_head),
              1e-6);
}

TEST(MakeHead, NamesWhatThereIs) {
    const auto made = make_head("nod", 1);
    ASSERT_FALSE(made);
    EXPECT_NE(made.error().text.find("look"), std::string::npos);
    for (const auto& info : head_motions()) EXPECT_TRUE(make_head(std::string(info.name), 1));
    for (const auto& info : eye_motions()) EXPECT_TRUE(make_eye(std::string(info.name), 1));
}

}  // namespace
}  // namespace foverig::motion
