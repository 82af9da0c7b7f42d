#include "devices/fusion/gyro_bias.h"

#include <gtest/gtest.h>

#include <cmath>

#include "devices/head_geometry.h"
#include "tests/devices/byte_text.h"

namespace foverig {
namespace {

const dvec3 kOffset_rad_s{0.004, -0.011, 0.002};

const dvec3 kUpright_m_s2{0, kGravity_m_s2, 0};
// Of a DK2 sample (DEVICES.md 6.2).
constexpr double kGyroNoise_rad_s = 3.1e-3, kAccelNoise_m_s2 = 0.099;

constexpr double kCold_c = 25.0;

/// Uniform with the standard deviation `sigma`.
dvec3 noise(test::Random& random, double sigma) {
    const auto one = [&] { return sigma * 3.4641 * (random.uniform() - 0.5); };
    return {one(), one(), one()};
}

void rest(GyroBias& bias, test::Random& random, int samples) {
    for (int i = 0; i < samples; ++i)
        bias.add(kOffset_rad_s + noise(random, kGyroNoise_rad_s),
                 kUpright_m_s2 + noise(random, kAccelNoise_m_s2), kCold_c, 1e-3);
}

TEST(GyroBias, IsLearntInSixSecondsAtRest) {
    GyroBias bias;
    test::Random random(1);
    rest(bias, random, 5999);
    EXPECT_FALSE(bias.known());
    rest(bias, random, 2);
    ASSERT_TRUE(bias.known());
    // The mean of 6000: 3.1e-3 / sqrt(6000) = 4e-5 at one sigma.
    EXPECT_LT(glm::length(bias.offset_rad_s(kCold_c) - kOffset_rad_s), 2e-4);
}

TEST(GyroBias, MotionAfterThreeSecondsKeepsWhatWasLearnt) {
    GyroBias bias;
    test::Random random(2);
    rest(bias, random, 4000);
    for (int i = 0; i < 100; ++i) bias.add(dvec3(0, 1, 0), kUpright_m_s2, kCold_c, 1e-3);
    ASSERT_TRUE(bias.known());
    EXPECT_LT(glm::length(bias.offset_rad_s(kCold_c) - kOffset_rad_s), 3e-4);
}

TEST(GyroBias, MotionBeforeThreeSecondsTeachesNothing) {
    GyroBias bias;
    for (int i = 0; i < 20000; ++i)
        bias.add(i % 2500 < 2400 ? kOffset_rad_s : dvec3(0.5, 0, 0), kUpright_m_s2, kCold_c, 1e-3);
    EXPECT_FALSE(bias.known());
}

TEST(GyroBias, ATurningHeadTeachesNothing) {
    GyroBias bias;
    for (int i = 0; i < 20000; ++i)
        bias.add(dvec3(0, 0.4 * std::sin(i * 1e-3), 0), kUpright_m_s2, kCold_c, 1e-3);
    EXPECT_FALSE(bias.known());
}

TEST(GyroBias, ASlowNodTeachesNothing) {
    // Neither the whole six seconds nor a part that a quick turn ends.
    const double rate_rad_s = glm::radians(1.5);
    for (const int quick_from : {4000, 7000}) {
        GyroBias bias;
        for (int i = 0; i < 7000; ++i) {
            const double angle_rad = rate_rad_s * i * 1e-3;
            const dvec3 gravity_m_s2 =
                kGravity_m_s2 * dvec3(0, std::cos(angle_rad), -std::sin(angle_rad));
            bias.add(dvec3(i < quick_from ? rate_rad_s : 0.5, 0, 0), gravity_m_s2, kCold_c, 1e-3);
        }
        EXPECT_FALSE(bias.known()) << quick_from;
    }
}

/// Rests for `seconds` while the chip warms by `c_per_s` from `from_c` and its offset follows.
void rest_and_warm(GyroBias& bias, test::Random& random, int seconds, double from_c, double c_per_s,
                   const dvec3& slope_rad_s_c) {
    for (int i = 0; i < 1000 * seconds; ++i) {
        const double celsius = from_c + c_per_s * 1e-3 * i;
        bias.add(
            kOffset_rad_s + (celsius - kCold_c) * slope_rad_s_c + noise(random, kGyroNoise_rad_s),
            kUpright_m_s2 + noise(random, kAccelNoise_m_s2), celsius, 1e-3);
    }
}

// 0.1 deg/s/C and -0.02. Two minutes from 25 to 28 C are 20 still moments: what is left of their
// noise is that of two ends, sqrt(2) * 4e-5 rad/s over 2.85 C = 2e-5 rad/s/C at one sigma, and the
// prior takes 2 % off.
TEST(GyroBias, LearnsItsSlopeWithTemperature) {
    const dvec3 slope_rad_s_c = glm::radians(dvec3(0.1, 0.0, -0.02));
    GyroBias bias;
    test::Random random(3);
    rest_and_warm(bias, random, 120, kCold_c, 0.025, slope_rad_s_c);
    ASSERT_TRUE(bias.known());
    const dvec3 error = bias.slope_rad_s_c() - slope_rad_s_c;
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LT(std::abs(error[axis]), 4 * 2e-5 + 0.03 * std::abs(slope_rad_s_c[axis])) << axis;
    }
    // Five degrees later, without a still moment.
    const dvec3 expected_rad_s = kOffset_rad_s + 8.0 * slope_rad_s_c;
    EXPECT_LT(glm::length(bias.offset_rad_s(33.0) - expected_rad_s), 6e-4);
    EXPECT_GT(glm::length(bias.offset_rad_s(28.0) - expected_rad_s), 8e-3);
}

TEST(GyroBias, OneTemperatureTeachesNoSlope) {
    GyroBias bias;
    test::Random random(4);
    rest(bias, random, 30000);
    EXPECT_EQ(bias.slope_rad_s_c(), dvec3(0));
    EXPECT_EQ(bias.offset_rad_s(kCold_c), bias.offset_rad_s(40.0));
}

// Two moments a tenth of a degree apart differ by their noise, not by their warmth.
TEST(GyroBias, AHardlyWarmerChipTeachesHardlyASlope) {
    GyroBias bias;
    test::Random random(5);
    rest_and_warm(bias, random, 13, kCold_c, 0.1 / 6.0, dvec3(0));
    EXPECT_LT(glm::length(bias.slope_rad_s_c()), 1.4e-3);
}

// A slow turn about the vertical is taken for rest, and its rate for an offset; a chip that is a
// tenth of a degree warmer cannot have moved by 1 deg/s.
TEST(GyroBias, ATurnThatIsTakenForRestTeachesNoSlope) {
    GyroBias bias;
    test::Random random(6);
    rest(bias, random, 6001);
    const dvec3 learnt_rad_s = bias.offset_rad_s(kCold_c);
    for (int i = 0; i < 6001; ++i)
        bias.add(kOffset_rad_s + glm::radians(dvec3(0, 1, 0)) + noise(random, kGyroNoise_rad_s),
                 kUpright_m_s2 + noise(random, kAccelNoise_m_s2), kCold_c + 0.1, 1e-3);
    EXPECT_GT(glm::distance(bias.offset_rad_s(kCold_c + 0.1), learnt_rad_s), glm::radians(0.9));
    EXPECT_LT(glm::length(bias.slope_rad_s_c()), 1e-9);
}

TEST(GyroBias, LearnsNoSlopeWhereItMayNot) {
    GyroBias bias(GyroBiasConfig{.slope_sigma_rad_s_c = 0});
    test::Random random(3);
    rest_and_warm(bias, random, 60, kCold_c, 0.05, dvec3(1e-3));
    EXPECT_EQ(bias.slope_rad_s_c(), dvec3(0));
}

}  // namespace
}  // namespace foverig
