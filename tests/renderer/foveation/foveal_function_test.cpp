#include "renderer/foveation/foveal_function.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace foverig {
namespace {

float probability(const FovealFunction& f, double eccentricity_deg) {
    return f(static_cast<float>(glm::radians(eccentricity_deg)));
}

TEST(FovealFunction, IsOneInsideLinearBetweenAndLeastOutside) {
    // Weier 2016 figure 3, at its "medium" configuration (10, 20, 0.05).
    const FovealFunction f(10.0, 20.0, 0.05);
    EXPECT_EQ(probability(f, 0.0), 1.0F);
    EXPECT_EQ(probability(f, 10.0), 1.0F);
    EXPECT_NEAR(probability(f, 12.5), 0.7625, 1.0e-5);
    EXPECT_NEAR(probability(f, 15.0), 0.525, 1.0e-5);
    EXPECT_NEAR(probability(f, 17.5), 0.2875, 1.0e-5);
    EXPECT_EQ(probability(f, 20.0), 0.05F);
    EXPECT_EQ(probability(f, 90.0), 0.05F);
}

TEST(FovealFunction, NeverRisesAndNeverLeavesItsRange) {
    for (const auto& [r0, r1, p] :
         {std::array{5.0, 10.0, 0.01}, std::array{15.0, 30.0, 0.1}, std::array{0.0, 60.0, 0.0}}) {
        const FovealFunction f(r0, r1, p);
        float last = 1.0F;
        for (int i = 0; i <= 9000; ++i) {
            const float value = probability(f, 0.01 * i);
            ASSERT_LE(value, last + 1.0e-7F);
            ASSERT_GE(value, static_cast<float>(p) - 1.0e-6F);
            last = value;
        }
        EXPECT_EQ(last, static_cast<float>(p));
    }
}

TEST(FovealFunction, EqualRadiiAreAStep) {
    const FovealFunction f(10.0, 10.0, 0.2);
    EXPECT_EQ(probability(f, 9.999), 1.0F);
    EXPECT_EQ(f(f.r0_rad), 1.0F);
    EXPECT_EQ(probability(f, 10.001), 0.2F);
}

TEST(FovealFunction, ZeroRadiusStillSeesItsCentre) {
    const FovealFunction f(0.0, 0.0, 0.05);
    EXPECT_EQ(f(0.0F), 1.0F);
    EXPECT_EQ(f(1.0e-6F), 0.05F);
}

TEST(FovealFunction, LeastProbabilityOfOneIsFullSampling) {
    const FovealFunction f(5.0, 10.0, 1.0);
    for (int i = 0; i < 900; ++i) ASSERT_EQ(probability(f, 0.1 * i), 1.0F);
}

TEST(FastAngle, AgreesWithAtan2InDoublePrecision) {
    double worst_rad = 0.0;
    for (int i = 0; i <= 400000; ++i) {
        const double angle = std::numbers::pi * i / 400000.0;
        for (const double length : {1.0e-3, 1.0, 700.0}) {
            const auto y = static_cast<float>(std::max(0.0, length * std::sin(angle)));
            const auto x = static_cast<float>(length * std::cos(angle));
            worst_rad = std::max(
                worst_rad, std::abs(static_cast<double>(fast_angle_rad(y, x)) -
                                    std::atan2(static_cast<double>(y), static_cast<double>(x))));
        }
    }
    EXPECT_LT(worst_rad, 5.0e-6);
}

TEST(FastAngle, HasItsLimitsOnTheAxesAndAtNothing) {
    EXPECT_EQ(fast_angle_rad(0.0F, 1.0F), 0.0F);
    EXPECT_NEAR(fast_angle_rad(1.0F, 0.0F), std::numbers::pi / 2, 1.0e-6);
    EXPECT_NEAR(fast_angle_rad(0.0F, -1.0F), std::numbers::pi, 1.0e-6);
    EXPECT_FALSE(std::isnan(fast_angle_rad(0.0F, 0.0F)));
}

TEST(AngleBetween, KeepsItsDigitsNearZeroAndNearPi) {
    for (const double angle : {1.0e-12, 1.0e-9, 1.0e-5, 0.1, 1.5}) {
        const dvec3 a(0.0, 0.0, -3.0);
        const dvec3 b(0.5 * std::sin(angle), 0.0, -0.5 * std::cos(angle));
        EXPECT_NEAR(angle_between_rad(a, b), angle, 1.0e-15 + 1.0e-14 * angle);
        EXPECT_NEAR(std::numbers::pi - angle_between_rad(a, -b), angle, 1.0e-15);
    }
    EXPECT_EQ(angle_between_rad({1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}), 0.0);
}

}  // namespace
}  // namespace foverig
