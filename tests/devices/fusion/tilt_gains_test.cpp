#include "devices/fusion/tilt_gains.h"

#include <gtest/gtest.h>

#include <cmath>

#include "devices/math.h"

namespace foverig {
namespace {

constexpr double kStep_s = 1e-3;

/// A tilt that an offset of the gyro carries away, about one axis, and what the gains make of it.
struct OneAxis {
    TiltGains gains;
    double offset_rad_s = 0;              ///< true
    double tilt_rad = 0, told_rad_s = 0;  ///< error that is left; offset that was learnt
    double worst_rad = 0;

    TiltGains::Shares step(bool teaches = true, double dt_s = kStep_s) {
        tilt_rad += dt_s * (offset_rad_s - told_rad_s);
        gains.pass(dt_s);
        const TiltGains::Shares shares = gains.pull(dvec3(tilt_rad, 0, 0), dt_s, teaches);
        told_rad_s += shares.offset_per_s * tilt_rad;
        tilt_rad -= shares.tilt * tilt_rad;
        worst_rad = std::max(worst_rad, std::abs(tilt_rad));
        return shares;
    }
    TiltGains::Shares run_for(double seconds, bool teaches = true) {
        TiltGains::Shares last;
        for (int i = 0; i < seconds / kStep_s; ++i) last = step(teaches);
        return last;
    }
};

TEST(TiltGains, EndAtTheGainAskedForAndAQuarterOfItsSquare) {
    for (const double gain : {0.25, 0.6}) {
        OneAxis axis{.gains = TiltGains({.end_gain_per_s = gain})};
        const TiltGains::Shares end = axis.run_for(300);
        EXPECT_NEAR(end.tilt / kStep_s, gain, 2e-3 * gain);
        EXPECT_NEAR(end.offset_per_s / kStep_s, 0.25 * gain * gain, 2e-3 * 0.25 * gain * gain);
    }
}

// Where neither tilt nor offset walks (a small end gain, the walk that keeps gravity's noise at
// 3.2e-3 rad sqrt(s)) what is learnt is the solution of all equations at once:
//   tilt(t) = tilt(0) + offset t, each told with that noise, and two priors.
TEST(TiltGains, AreThoseOfLeastSquares) {
    constexpr double kNoise = 3.2e-3, kSigma_rad_s = 3.5e-3, kTilt_rad = 0.5, kGain = 0.01;
    constexpr double kOffset_rad_s = 2e-4, kTime_s = 5.0;  // too small to look like a sway
    OneAxis axis{.gains = TiltGains({.end_gain_per_s = kGain,
                                     .offset_sigma_rad_s = kSigma_rad_s,
                                     .walk_rad_s_sqrt_s = kNoise * 0.25 * kGain * kGain,
                                     .response_s = 1e-9}),
                 .offset_rad_s = kOffset_rad_s};
    axis.run_for(kTime_s);
    const double weight = kStep_s / (kNoise * kNoise);
    double a = 1 / (kTilt_rad * kTilt_rad), b = 0, c = 1 / (kSigma_rad_s * kSigma_rad_s);
    double right_a = 0, right_b = 0;
    for (double t_s = kStep_s; t_s < kTime_s + 0.5 * kStep_s; t_s += kStep_s) {
        const double told_rad = kOffset_rad_s * t_s;
        a += weight;
        b += weight * t_s;
        c += weight * t_s * t_s;
        right_a += weight * told_rad;
        right_b += weight * t_s * told_rad;
    }
    const double expected_rad_s = (a * right_b - b * right_a) / (a * c - b * b);
    EXPECT_GT(expected_rad_s, 0.8 * kOffset_rad_s) << "five seconds teach most of it";
    EXPECT_NEAR(axis.told_rad_s, expected_rad_s, 2e-3 * kOffset_rad_s);
}

// Before: after 4 s, with the end's gains alone: 0.87 degrees at 9 s.
TEST(TiltGains, AnUnknownOffsetHardlyTilts) {
    OneAxis axis{.gains = TiltGains(), .offset_rad_s = glm::radians(0.283)};
    axis.run_for(2);
    EXPECT_LT(axis.worst_rad, glm::radians(0.25));
    axis.run_for(8);
    EXPECT_NEAR(axis.told_rad_s, axis.offset_rad_s, 0.05 * axis.offset_rad_s);
    EXPECT_LT(std::abs(axis.tilt_rad), glm::radians(0.02));
}

TEST(TiltGains, AfterAStillMomentTheyAreTheEnds) {
    constexpr double kEnd_per_s2 = 0.25 * 0.25 / 4;
    OneAxis early{.gains = TiltGains()}, late = early;
    EXPECT_GT(early.run_for(3).offset_per_s, 10 * kEnd_per_s2 * kStep_s);
    early.gains.offset_told();
    EXPECT_LT(early.step().offset_per_s, 1.01 * kEnd_per_s2 * kStep_s);
    late.run_for(300);
    late.gains.offset_told();
    for (int i = 0; i < 10; ++i) {
        EXPECT_NEAR(late.step().offset_per_s / kStep_s, kEnd_per_s2, 1e-3 * kEnd_per_s2);
        EXPECT_NEAR(late.run_for(1).tilt / kStep_s, 0.25, 1e-3 * 0.25);
    }
}

TEST(TiltGains, WhatDoesNotTeachPullsAsAPlainMeanAndThenAsTheEnd) {
    OneAxis axis{.gains = TiltGains()};
    for (int i = 1; i <= 20000; ++i) {
        const TiltGains::Shares shares = axis.step(false);
        EXPECT_EQ(shares.offset_per_s, 0.0);
        const double plain_per_s = 1 / (i * kStep_s + 0.1);
        ASSERT_NEAR(shares.tilt / kStep_s, std::max(0.25, plain_per_s), 1e-3) << i;
    }
}

TEST(TiltGains, ATiltThatIsForgottenIsFoundAgainWithoutBlamingTheGyro) {
    OneAxis axis{.gains = TiltGains()};
    axis.run_for(60);
    axis.gains.forget_tilt();
    axis.tilt_rad = 0.3;
    axis.run_for(2);
    EXPECT_LT(std::abs(axis.tilt_rad), glm::radians(0.2));
    EXPECT_LT(std::abs(axis.told_rad_s), glm::radians(0.02));
}

// 0.2 m/s2 of a swaying body are 1.2 degrees of gravity.
TEST(TiltGains, ASwayIsNotTakenForTheOffset) {
    OneAxis still{.gains = TiltGains()};
    const double when_still = still.run_for(2).offset_per_s;
    TiltGains gains;
    TiltGains::Shares swaying;
    for (int i = 0; i < 2000; ++i) {
        gains.pass(kStep_s);
        swaying = gains.pull(dvec3(0.02 * std::sin(2 * i * kStep_s), 0, 0), kStep_s, true);
    }
    EXPECT_LT(swaying.offset_per_s, 0.5 * when_still);
    EXPECT_GT(swaying.offset_per_s, 0.0);
}

TEST(TiltGains, LongStepsStayWithinOne) {
    OneAxis axis{.gains = TiltGains(), .offset_rad_s = 0.01};
    for (int i = 0; i < 2000; ++i) {
        const TiltGains::Shares shares = axis.step(i % 3 != 0, 0.25);
        ASSERT_GE(shares.tilt, 0.0);
        ASSERT_LE(shares.tilt, 1.0);
        ASSERT_TRUE(std::isfinite(axis.told_rad_s));
    }
    EXPECT_NEAR(axis.told_rad_s, 0.01, 1e-3);
}

}  // namespace
}  // namespace foverig
