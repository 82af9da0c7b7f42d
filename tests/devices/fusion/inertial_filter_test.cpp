#include "devices/fusion/inertial_filter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "devices/fusion/delayed_filter.h"
#include "devices/fusion/rotation.h"
#include "devices/head_geometry.h"

namespace foverig {
namespace {

using State = InertialFilter::State;

/// Turning about y at a steady rate, while the place swings along x.
struct Ride {
    static constexpr double kRate_rad_s = 1.5, kSwing_m = 0.1, kSwing_rad_s = 4.0;

    RigidPose pose(double t) const {
        return {exp_map({0, kRate_rad_s * t, 0}), {kSwing_m * std::sin(kSwing_rad_s * t), 0, 0}};
    }
    dvec3 velocity(double t) const {
        return {kSwing_m * kSwing_rad_s * std::cos(kSwing_rad_s * t), 0, 0};
    }
    Inertial sensed(double t) const {
        const dvec3 acceleration(
            -kSwing_m * kSwing_rad_s * kSwing_rad_s * std::sin(kSwing_rad_s * t), 0, 0);
        return {.gyro_rad_s = {0, kRate_rad_s, 0},
                .accel_m_s2 =
                    glm::conjugate(pose(t).rotation) * (acceleration + dvec3(0, kGravity_m_s2, 0))};
    }
    ImuSample sample(int ms) const {
        const double t = 1e-3 * ms;
        ImuSample s;
        s.device_time = Dk2Time(std::chrono::milliseconds(ms));
        s.host_time = HostTime(std::chrono::milliseconds(ms));
        s.gyro_rad_s = sensed(t).gyro_rad_s;
        s.accel_m_s2 = sensed(t).accel_m_s2;
        return s;
    }
};

Matrix<6, 6> good_fix() {
    Matrix<6, 6> m = Matrix<6, 6>::identity();
    m *= 1e-6;
    return m;
}

TEST(InertialFilter, IntegratesAnAnalyticRide) {
    const Ride ride;
    State state = InertialFilter::start(ride.pose(0), ride.velocity(0));
    for (int i = 0; i < 2000; ++i) {
        InertialFilter::advance(state, ride.sensed(1e-3 * i), ride.sensed(1e-3 * (i + 1)), 1e-3,
                                {});
    }
    EXPECT_LT(glm::distance(state.position_m, ride.pose(2).translation_m), 1e-5);
    EXPECT_LT(glm::distance(state.velocity_m_s, ride.velocity(2)), 1e-5);
    EXPECT_LT(angle_between(state.world_from_body, ride.pose(2).rotation), 1e-9);
}

// The covariance says how a small error of the start grows; so do two runs that differ by it.
TEST(InertialFilter, CovarianceGrowsAsErrorsDo) {
    const Ride ride;
    const InertialNoise silent{.gyro_rad_sqrt_s = 0,
                               .gyro_scale = 0,
                               .accel_m_s_sqrt_s = 0,
                               .gyro_walk_rad_s_sqrt_s = 0,
                               .accel_walk_m_s2_sqrt_s = 0};
    constexpr double kError = 1e-4;
    for (std::size_t part = 0; part < 15; ++part) {
        State truth = InertialFilter::start(ride.pose(0), ride.velocity(0));
        truth.covariance = {};
        truth.covariance(part, part) = kError * kError;
        State off = truth;
        dvec3 step(0);
        step[static_cast<int>(part % 3)] = kError;
        switch (part / 3) {
            case 0:
                off.position_m += step;
                break;
            case 1:
                off.velocity_m_s += step;
                break;
            case 2:
                off.world_from_body = off.world_from_body * exp_map(step);
                break;
            case 3:
                off.accel_bias_m_s2 += step;
                break;
            default:
                off.gyro_bias_rad_s += step;
                break;
        }
        for (int i = 0; i < 500; ++i) {
            const Inertial before = ride.sensed(1e-3 * i), after = ride.sensed(1e-3 * (i + 1));
            InertialFilter::advance(truth, before, after, 1e-3, silent);
            InertialFilter::advance(off, before, after, 1e-3, silent);
        }
        const dvec3 way = off.position_m - truth.position_m;
        const dvec3 turn = log_map(glm::conjugate(truth.world_from_body) * off.world_from_body);
        const auto sigma = [&](std::size_t i) {
            return std::sqrt(std::max(0.0, truth.covariance(i, i)));
        };
        for (std::size_t k = 0; k < 3; ++k) {
            const int axis = static_cast<int>(k);
            EXPECT_NEAR(sigma(k), std::abs(way[axis]), 0.02 * glm::length(way) + 1e-9) << part;
            EXPECT_NEAR(sigma(6 + k), std::abs(turn[axis]), 0.02 * glm::length(turn) + 1e-9)
                << part;
        }
    }
}

TEST(InertialFilter, FixesFindBothBiases) {
    const Ride ride;
    const dvec3 gyro_bias(0.01, -0.02, 0.015), accel_bias(0.1, 0.05, -0.08);
    State state = InertialFilter::start(ride.pose(0), ride.velocity(0));
    const auto biased = [&](double t) {
        Inertial sensed = ride.sensed(t);
        sensed.gyro_rad_s += gyro_bias;
        sensed.accel_m_s2 += accel_bias;
        return sensed;
    };
    for (int i = 0; i < 20'000; ++i) {
        InertialFilter::advance(state, biased(1e-3 * i), biased(1e-3 * (i + 1)), 1e-3, {});
        if (i % 16 == 15)
            InertialFilter::measure_pose(state, ride.pose(1e-3 * (i + 1)), good_fix(), 1e9);
    }
    EXPECT_LT(glm::distance(state.gyro_bias_rad_s, gyro_bias), 1e-3);
    EXPECT_LT(glm::distance(state.accel_bias_m_s2, accel_bias), 0.02);
}

TEST(InertialFilter, AnUnlikelyFixChangesNothing) {
    const Ride ride;
    State state = InertialFilter::start(ride.pose(0), ride.velocity(0));
    const State before = state;
    RigidPose wrong = ride.pose(0);
    wrong.translation_m.z += 0.5;
    EXPECT_GT(InertialFilter::measure_pose(state, wrong, good_fix(), 30.0), 30.0);
    EXPECT_EQ(state.position_m, before.position_m);
    EXPECT_EQ(state.covariance.values, before.covariance.values);
}

// A fix of 30 ms ago, told now, does what it would have done then.
TEST(DelayedFilter, ALateFixIsAsGoodAsAPromptOne) {
    const Ride ride;
    DelayedFilter late, prompt;
    RigidPose off = ride.pose(0);
    off.translation_m += dvec3(0.004, -0.003, 0.002);
    for (DelayedFilter* f : {&late, &prompt}) f->start(ride.sample(0), off, ride.velocity(0));
    const Dk2Time taken{std::chrono::microseconds(50'400)};
    const RigidPose seen = ride.pose(0.0504);
    for (int ms = 1; ms <= 80; ++ms) {
        late.add(ride.sample(ms));
        prompt.add(ride.sample(ms));
        if (ms != 51) continue;
        EXPECT_EQ(prompt.add(taken, seen, good_fix()), DelayedFilter::Verdict::taken);
    }
    EXPECT_EQ(late.add(taken, seen, good_fix()), DelayedFilter::Verdict::taken);
    EXPECT_EQ(late.now().position_m, prompt.now().position_m);
    EXPECT_EQ(late.now().world_from_body, prompt.now().world_from_body);
    EXPECT_LT(glm::distance(late.now().position_m, ride.pose(0.08).translation_m), 0.004);
}

TEST(DelayedFilter, FixesBeyondItsMemoryAreTooOld) {
    const Ride ride;
    DelayedFilter filter;
    filter.start(ride.sample(0), ride.pose(0), ride.velocity(0));
    for (int ms = 1; ms <= 500; ++ms) filter.add(ride.sample(ms));
    const auto at = [](int ms) { return Dk2Time(std::chrono::milliseconds(ms)); };
    EXPECT_EQ(filter.add(at(250), ride.pose(0.25), good_fix()), DelayedFilter::Verdict::too_old);
    EXPECT_EQ(filter.add(at(501), ride.pose(0.501), good_fix()), DelayedFilter::Verdict::too_old);
    EXPECT_EQ(filter.add(at(480), ride.pose(0.48), good_fix()), DelayedFilter::Verdict::taken);
}

}  // namespace
}  // namespace foverig
