#include <gtest/gtest.h>

#include <cmath>

#include "simulators/motion/blinks.h"
#include "simulators/motion/scan_eye.h"
#include "simulators/motion/target_eye.h"

namespace foverig::motion {
namespace {

TEST(Direction, RoundTripsAndPointsAhead) {
    EXPECT_EQ(direction_of({0.0, 0.0}), dvec3(0.0, 0.0, -1.0));
    EXPECT_GT(direction_of({10.0, 0.0}).x, 0.0);
    EXPECT_GT(direction_of({0.0, 10.0}).y, 0.0);
    const dvec2 back = gaze_of(direction_of({-17.0, 12.0}));
    EXPECT_NEAR(back.x, -17.0, 1e-12);
    EXPECT_NEAR(back.y, 12.0, 1e-12);
}

TEST(ScanEye, FixatesAsLongAsDocumented) {
    // 5.2: ex-Gaussian 180 + 110 ms, floor 80 ms: mean about 290 ms, right-skewed.
    double sum = 0, shortest = 1.0;
    int n = 0, above = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const ScanEye scan(seed);
        for (const auto& fixation : scan.fixations()) {
            const double length_s = fixation.end_s - fixation.start_s;
            if (&fixation == &scan.fixations().back()) break;
            sum += length_s;
            shortest = std::min(shortest, length_s);
            above += length_s > 0.290 ? 1 : 0;
            ++n;
        }
    }
    EXPECT_NEAR(sum / n, 0.290, 0.004);
    EXPECT_GE(shortest, 0.080 - 1e-12);
    EXPECT_LT(above, 0.45 * n);
}

TEST(ScanEye, MakesMicroSaccadesAtTheDocumentedRate) {
    const ScanEye scan(2);
    double fixating_s = 0.0;
    for (const auto& fixation : scan.fixations()) fixating_s += fixation.end_s - fixation.start_s;
    int micro = 0;
    for (const GazeLeg& leg : scan.path().legs()) {
        const double amplitude_deg = glm::length(leg.jump_deg);
        if (amplitude_deg > 0.0 && amplitude_deg < 0.999) {
            ++micro;
            EXPECT_GE(amplitude_deg, 0.0999);
        }
    }
    // Those that would not end within their fixation are left out, a tenth of them.
    EXPECT_NEAR(micro / fixating_s, 1.2, 0.2);
}

TEST(ScanEye, StaysWithinItsReachAndNeverJumps) {
    const ScanEye scan(3);
    dvec2 before = gaze_of(scan.at(0.0).direction);
    constexpr double kStep_s = 1e-3;
    for (double t = kStep_s; t < ScanEye::kCycle_s + 1.0; t += kStep_s) {
        const dvec2 now = gaze_of(scan.at(t).direction);
        ASSERT_LT(glm::distance(now, before) / kStep_s, 540.0) << t;  // V_max and drift
        ASSERT_LT(glm::length(now), ScanEye::kReach_deg + 2.0) << t;
        before = now;
    }
}

TEST(ScanEye, DriftDiffusesAtTheDocumentedSpeed) {
    ScanEye::Settings settings;
    settings.target_sigma_deg = 3.0;
    settings.micro_rate_hz = 0.0;
    settings.fixation_mu_s = 1.0;
    // Variance 2 D t per axis, D = 30 arcmin^2/s, over lags inside one fixation.
    for (const double lag_s : {0.1, 0.2}) {
        double square = 0.0;
        int n = 0;
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const ScanEye scan(seed, settings);
            for (const auto& fixation : scan.fixations()) {
                for (double t = fixation.start_s + 0.1; t + lag_s < fixation.end_s; t += 0.05) {
                    const dvec2 way = 60.0 * (gaze_of(scan.at(t + lag_s).direction) -
                                              gaze_of(scan.at(t).direction));
                    square += 0.5 * glm::dot(way, way);
                    ++n;
                }
            }
        }
        EXPECT_NEAR(square / n, 2.0 * 30.0 * lag_s, 0.25 * 60.0 * lag_s) << lag_s;
    }
}

TEST(Blinks, ComeAtTheRateAskedForWithTheirDeadTime) {
    int n = 0;
    double length_s = 0.0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const Blinks blinks(seed, 14.0);
        for (std::size_t i = 0; i < blinks.blinks().size(); ++i) {
            length_s += blinks.blinks()[i].duration_s;
            if (i > 0) {
                EXPECT_GE(blinks.blinks()[i].start_s - blinks.blinks()[i - 1].start_s, 0.5);
            }
            ++n;
        }
    }
    // 5.4: 14 a minute over 100 minutes; log-normal 180 ms with sigma 0.35 has mean 191 ms.
    EXPECT_NEAR(n / 100.0, 14.0, 1.0);
    EXPECT_NEAR(length_s / n, 0.180 * std::exp(0.5 * 0.35 * 0.35), 0.006);
}

TEST(Blinks, LidGoesDownStaysAndComesUp) {
    const Blinks blinks(1, 14.0);
    const auto [start_s, duration_s] = blinks.blinks().front();
    EXPECT_EQ(blinks.openness(start_s - 1e-6), 1.0);
    EXPECT_NEAR(blinks.openness(start_s + 0.2 * duration_s), 0.5, 1e-9);
    EXPECT_EQ(blinks.openness(start_s + 0.5 * duration_s), 0.0);
    EXPECT_NEAR(blinks.openness(start_s + 0.8 * duration_s), 0.5, 1e-9);
    EXPECT_EQ(blinks.openness(start_s + 1.001 * duration_s), 1.0);
    EXPECT_TRUE(Blinks(1, 0.0).blinks().empty());
}

TEST(TargetEye, MovesInStraightLinesAtItsSpeed) {
    const GazePath path = target_path(1, {.speed_deg_s = 12.0, .reach_deg = 10.0});
    for (std::size_t i = 0; i + 1 < path.legs().size(); ++i) {
        if (i + 2 < path.legs().size()) {
            EXPECT_NEAR(glm::length(path.legs()[i].glide_deg_s), 12.0, 1e-9);
        }
        const dvec2 corner = path.gaze_deg(path.legs()[i + 1].start_s);
        EXPECT_LE(std::abs(corner.x), 10.0 + 1e-9);
        EXPECT_LE(std::abs(corner.y), 10.0 + 1e-9);
    }
    EXPECT_LT(glm::distance(path.gaze_deg(60.0 - 1e-9), path.gaze_deg(0.0)), 1e-6);
}

TEST(PursuitEye, FollowsLateAndCatchesUp) {
    const PursuitEye eye(1, {.speed_deg_s = 15.0, .reach_deg = 10.0});
    double worst = 0.0, sum = 0.0;
    int n = 0;
    for (double t = 0.5; t < 59.0; t += 0.001, ++n) {
        const double error = glm::distance(gaze_of(eye.at(t).direction), eye.target().gaze_deg(t));
        worst = std::max(worst, error);
        sum += error;
    }
    // Up to a reversal's 2 x 15 deg/s over 125 ms plus the saccade's 30 ms, and the slip.
    EXPECT_LT(worst, 30.0 * 0.16 + 1.2);
    EXPECT_GT(worst, 1.0);
    EXPECT_LT(sum / n, 1.5);
}

TEST(PursuitEye, RunsWithItsGainBetweenSaccades) {
    const PursuitEye eye(1, {.speed_deg_s = 15.0, .reach_deg = 10.0});
    for (const GazeLeg& leg : eye.path().legs()) {
        const double speed = glm::length(leg.glide_deg_s);
        if (speed > 0.0 && leg.start_s < 55.0) {
            EXPECT_NEAR(speed, 0.95 * 15.0, 1e-9);
        }
    }
}

}  // namespace
}  // namespace foverig::motion
