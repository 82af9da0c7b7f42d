// The arithmetic under the built-in scenes, against libm in higher precision.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "renderer/scene/builtin/exact.h"
#include "renderer/scene/builtin/hash.h"
#include "renderer/scene/builtin/noise.h"

namespace foverig::builtin {
namespace {

TEST(BuiltinExact, SineAndCosineAgreeWithLibm) {
    for (int i = -4000; i <= 4000; ++i) {
        const float turns = static_cast<float>(i) * 0.00137F;
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(turns);
        ASSERT_NEAR(sine(turns), std::sin(angle), 1.0e-6);
        ASSERT_NEAR(cosine(turns), std::cos(angle), 2.0e-6) << turns;  // turns + 1/4 is rounded
    }
}

TEST(BuiltinExact, QuarterTurnsAreExact) {
    EXPECT_EQ(rotate_y({1.0F, 2.0F, 3.0F}, 0.25F), (vec3{3.0F, 2.0F, -1.0F}));
    EXPECT_EQ(rotate_y({1.0F, 2.0F, 3.0F}, 0.5F), (vec3{-1.0F, 2.0F, -3.0F}));
    EXPECT_EQ(rotate_y({1.0F, 2.0F, 3.0F}, -0.25F), (vec3{-3.0F, 2.0F, 1.0F}));
}

TEST(BuiltinExact, SrgbDecodingAgreesWithItsDefinition) {
    for (int i = 0; i <= 255; ++i) {
        const double s = i / 255.0;
        const double linear = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
        ASSERT_NEAR(linear_of_srgb(static_cast<float>(s)), linear, 2.0e-7) << i;
    }
}

TEST(BuiltinHash, DrawsAreUniform) {
    // Chi-square of 64 bins; the 99.9 % point with 63 degrees of freedom is 103.4.
    constexpr int kDraws = 64 * 1000;
    std::vector<int> bins(64);
    Dice dice(7);
    for (int i = 0; i < kDraws; ++i) ++bins[static_cast<std::size_t>(dice.below(64))];
    double chi2 = 0.0;
    for (const int n : bins) chi2 += (n - 1000.0) * (n - 1000.0) / 1000.0;
    EXPECT_LT(chi2, 103.4);
}

TEST(BuiltinNoise, VanishesOnTheLatticeAndTiles) {
    for (int i = 0; i < 5; ++i) {
        for (int j = 0; j < 5; ++j) {
            EXPECT_EQ(noise(vec2{static_cast<float>(i), static_cast<float>(j)}, 8, 3), 0.0F);
            const vec2 p{static_cast<float>(i) + 0.375F, static_cast<float>(j) + 0.625F};
            EXPECT_EQ(noise(p, 4, 3), noise(p + vec2{4.0F, 8.0F}, 4, 3));
        }
    }
}

TEST(BuiltinNoise, IsContinuousAcrossCells) {
    for (float x = 0.0F; x < 8.0F; x += 0.25F) {
        const vec3 p{x, 1.3F, 0.7F};
        EXPECT_NEAR(noise(p - vec3{1.0e-4F, 0, 0}, 5), noise(p + vec3{1.0e-4F, 0, 0}, 5), 1.0e-3F);
    }
}

}  // namespace
}  // namespace foverig::builtin
