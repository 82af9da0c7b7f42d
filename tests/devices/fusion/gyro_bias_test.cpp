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

/// Uniform with the standard deviation `sigma`.
dvec3 noise(test::Random& random, double sigma) {
    const auto one = [&] { return sigma * 3.4641 * (random.uniform() - 0.5); };
    return {one(), one(), one()};
}

void rest(GyroBias& bias, test::Random& random, int samples) {
    for (int i = 0; i < samples; ++i)
        bias.add(kOffset_rad_s + noise(random, kGyroNoise_rad_s),
                 kUpright_m_s2 + noise(random, kAccelNoise_m_s2), 1e-3);
}

TEST(GyroBias, IsLearntInSixSecondsAtRest) {
    GyroBias bias;
    test::Random random(1);
    rest(bias, random, 5999);
    EXPECT_FALSE(bias.known());
    rest(bias, random, 2);
    ASSERT_TRUE(bias.known());
    // The mean of 6000: 3.1e-3 / sqrt(6000) = 4e-5 at one sigma.
    EXPECT_LT(glm::length(bias.offset_rad_s() - kOffset_rad_s), 2e-4);
}

TEST(GyroBias, MotionAfterThreeSecondsKeepsWhatWasLearnt) {
    GyroBias bias;
    test::Random random(2);
    rest(bias, random, 4000);
    for (int i = 0; i < 100; ++i) bias.add(dvec3(0, 1, 0), kUpright_m_s2, 1e-3);
    ASSERT_TRUE(bias.known());
    EXPECT_LT(glm::length(bias.offset_rad_s() - kOffset_rad_s), 3e-4);
}

TEST(GyroBias, MotionBeforeThreeSecondsTeachesNothing) {
    GyroBias bias;
    for (int i = 0; i < 20000; ++i)
        bias.add(i % 2500 < 2400 ? kOffset_rad_s : dvec3(0.5, 0, 0), kUpright_m_s2, 1e-3);
    EXPECT_FALSE(bias.known());
}

TEST(GyroBias, ATurningHeadTeachesNothing) {
    GyroBias bias;
    for (int i = 0; i < 20000; ++i)
        bias.add(dvec3(0, 0.4 * std::sin(i * 1e-3), 0), kUpright_m_s2, 1e-3);
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
            bias.add(dvec3(i < quick_from ? rate_rad_s : 0.5, 0, 0), gravity_m_s2, 1e-3);
        }
        EXPECT_FALSE(bias.known()) << quick_from;
    }
}

}  // namespace
}  // namespace foverig
