#include "devices/fusion/gyro_bias.h"

#include <gtest/gtest.h>

#include "tests/devices/byte_text.h"

namespace foverig {
namespace {

const dvec3 kOffset_rad_s{0.004, -0.011, 0.002};

dvec3 noise(test::Random& random) {
    // Uniform with the standard deviation of a DK2 sample, 3.1e-3 rad/s (DEVICES.md 6.2).
    const auto one = [&] { return 3.1e-3 * 3.4641 * (random.uniform() - 0.5); };
    return {one(), one(), one()};
}

TEST(GyroBias, IsLearntInSixSecondsAtRest) {
    GyroBias bias;
    test::Random random(1);
    for (int i = 0; i < 5999; ++i) bias.add(kOffset_rad_s + noise(random), 1e-3);
    EXPECT_FALSE(bias.known());
    for (int i = 0; i < 2; ++i) bias.add(kOffset_rad_s + noise(random), 1e-3);
    ASSERT_TRUE(bias.known());
    // The mean of 6000: 3.1e-3 / sqrt(6000) = 4e-5 at one sigma.
    EXPECT_LT(glm::length(bias.offset_rad_s() - kOffset_rad_s), 2e-4);
}

TEST(GyroBias, MotionAfterThreeSecondsKeepsWhatWasLearnt) {
    GyroBias bias;
    test::Random random(2);
    for (int i = 0; i < 4000; ++i) bias.add(kOffset_rad_s + noise(random), 1e-3);
    for (int i = 0; i < 100; ++i) bias.add(dvec3(0, 1, 0), 1e-3);
    ASSERT_TRUE(bias.known());
    EXPECT_LT(glm::length(bias.offset_rad_s() - kOffset_rad_s), 3e-4);
}

TEST(GyroBias, MotionBeforeThreeSecondsTeachesNothing) {
    GyroBias bias;
    for (int i = 0; i < 20000; ++i)
        bias.add(i % 2500 < 2400 ? kOffset_rad_s : dvec3(0.5, 0, 0), 1e-3);
    EXPECT_FALSE(bias.known());
}

TEST(GyroBias, ATurningHeadTeachesNothing) {
    GyroBias bias;
    for (int i = 0; i < 20000; ++i) bias.add(dvec3(0, 0.4 * std::sin(i * 1e-3), 0), 1e-3);
    EXPECT_FALSE(bias.known());
}

}  // namespace
}  // namespace foverig
