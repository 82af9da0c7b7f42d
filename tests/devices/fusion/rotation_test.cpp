#include "devices/fusion/rotation.h"

#include <gtest/gtest.h>

namespace foverig {
namespace {

TEST(ExpMap, SeriesMeetsTheClosedFormWhereTheySwitch) {
    // Long double sine and cosine are the witness on both sides of 0.01 rad.
    for (const double angle :
         {1e-12, 1e-6, 1e-3, 0.00999, 0.0099999, 0.010001, 0.0101, 0.1, 1.0, 3.0}) {
        const dvec3 axis = glm::normalize(dvec3(1, -2, 0.5));
        const dquat q = exp_map(angle * axis);
        const long double half = 0.5L * angle;
        EXPECT_NEAR(q.w, static_cast<double>(cosl(half)), 3e-16) << angle;
        EXPECT_NEAR(q.x / (axis.x * angle), static_cast<double>(sinl(half) / angle), 1e-15)
            << angle;
    }
}

TEST(ExpMap, ZeroIsTheIdentity) {
    EXPECT_EQ(exp_map(dvec3(0)), dquat(1, 0, 0, 0));
}

TEST(LogMap, UndoesExpMap) {
    for (double angle = 1e-9; angle < 3.14; angle *= 1.7) {
        const dvec3 v = angle * glm::normalize(dvec3(0.3, 1, -2));
        EXPECT_NEAR(glm::length(log_map(exp_map(v)) - v) / angle, 0, 1e-12) << angle;
        EXPECT_NEAR(glm::length(log_map(-exp_map(v)) - v) / angle, 0, 1e-12) << angle;
    }
}

TEST(RotationOfRates, IsFourthOrderForAConeThatTheMeanRateMisses) {
    // A body rate that turns out of its axis by 15 rad/s^2, against 20 000 small steps.
    const auto error = [](double dt_s, bool coning) {
        const dvec3 start(3, 0, 0), end = start + dt_s * dvec3(-15, 15, 0);
        dquat truth(1, 0, 0, 0);
        constexpr int kSteps = 20000;
        for (int i = 0; i < kSteps; ++i)
            truth = truth * exp_map(glm::mix(start, end, (i + 0.5) / kSteps) * (dt_s / kSteps));
        const dvec3 v = coning ? rotation_of_rates(start, end, dt_s) : 0.5 * dt_s * (start + end);
        return angle_between(truth, exp_map(v));
    };
    EXPECT_LT(error(0.05, true), error(0.05, false) / 50);
    // An error of h^5 a step: a quarter of the step is 1024 times better.
    EXPECT_LT(error(0.05, true), error(0.2, true) / 500);
}

}  // namespace
}  // namespace foverig
