#include "renderer/kernels/running_estimate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace foverig {
namespace {

TEST(SmallestWeight, RunsFromLeastToMostExponentially) {
    // k_t of Weier 2016 3.4, in double: k_min (k_max / k_min)^((dt - 1) / (t_max - 1)).
    const SmallestWeight k(0.1, 1.0, 30);
    EXPECT_NEAR(k(1), 0.1, 1.0e-7);
    EXPECT_NEAR(k(30), 1.0, 1.0e-6);
    for (std::uint32_t dt = 1; dt <= 30; ++dt)
        EXPECT_NEAR(k(dt), 0.1 * std::pow(10.0, (dt - 1.0) / 29.0), 1.0e-6) << dt;
}

TEST(SmallestWeight, StaysAtItsMostBeyondTheLongestAge) {
    const SmallestWeight k(0.1, 0.8, 5);
    EXPECT_EQ(k(6), 0.8F);
    EXPECT_EQ(k(1000), 0.8F);
    EXPECT_EQ(k(0xFFFF), 0.8F);
}

TEST(SmallestWeight, OneFrameOfMemoryLeavesNoRange) {
    const SmallestWeight k(0.1, 0.9, 1);
    for (const std::uint32_t dt : {1U, 2U, 50U}) EXPECT_NEAR(k(dt), 0.9F, 1.0e-6F);
}

TEST(SmallestWeight, AConstantRateIsConstant) {
    const SmallestWeight k(0.3, 0.3, 30);
    for (std::uint32_t dt = 1; dt < 60; ++dt) ASSERT_NEAR(k(dt), 0.3F, 1.0e-6F);
}

TEST(NewSampleWeight, IsAtLeastTheSmallestWeight) {
    // As the paper's words say; its formula min{alpha', k} would give the others.
    EXPECT_FLOAT_EQ(new_sample_weight(1.0F, 0.1F), 0.5F);
    EXPECT_FLOAT_EQ(new_sample_weight(99.0F, 0.1F), 0.1F);
    EXPECT_FLOAT_EQ(new_sample_weight(3.0F, 0.25F), 0.25F);
}

TEST(NewSampleWeight, APixelNeverSampledTakesItsFirstSampleAlone) {
    EXPECT_EQ(new_sample_weight(0.0F, 0.1F), 1.0F);
    EXPECT_EQ(accumulated_samples(0.0F, 1.0F), 1.0F);
}

TEST(AccumulatedSamples, CountSamplesWhileEachWeighsTheSame) {
    // With alpha = 1/(rho + 1), rho counts: 1, 2, 3, ...
    float rho = 0.0F;
    for (int n = 1; n <= 200; ++n) {
        rho = accumulated_samples(rho, new_sample_weight(rho, 0.0F));
        ASSERT_NEAR(rho, n, 1.0e-4 * n);
    }
}

TEST(AccumulatedSamples, SettleWhereTheSmallestWeightHolds) {
    // Fixed point of rho = 1/(k^2 + (1-k)^2/rho): rho = (1 - (1-k)^2)/k^2 = (2 - k)/k.
    const double k = 0.1;
    float rho = 0.0F;
    for (int n = 0; n < 500; ++n)
        rho = accumulated_samples(rho, new_sample_weight(rho, static_cast<float>(k)));
    EXPECT_NEAR(rho, (2.0 - k) / k, 1.0e-3);
}

TEST(AccumulatedSamples, AFullReplacementIsOneSampleAgain) {
    EXPECT_EQ(accumulated_samples(50.0F, 1.0F), 1.0F);
}

TEST(RunningEstimate, OfIndependentSamplesHasTheVarianceThatRhoSays) {
    // Weights of all samples so far, squared and summed, against 1/rho.
    std::vector<double> weights;
    float rho = 0.0F;
    for (int n = 0; n < 60; ++n) {
        const float alpha = new_sample_weight(rho, 0.05F);
        for (double& w : weights) w *= 1.0 - static_cast<double>(alpha);
        weights.push_back(static_cast<double>(alpha));
        rho = accumulated_samples(rho, alpha);
        double variance = 0.0;
        for (const double w : weights) variance += w * w;
        ASSERT_NEAR(rho * variance, 1.0, 1.0e-3) << n;
    }
}

TEST(CacheInfo, AgeIsAtLeastOneAndWrapsWithTheFrameCounter) {
    EXPECT_EQ(age_frames(touched_in(100U), 103U), 3U);
    EXPECT_EQ(age_frames(touched_in(7U), 7U), 1U);
    EXPECT_EQ(age_frames(touched_in(0xFFFFU), 0x10000U), 1U);
    EXPECT_EQ(age_frames(touched_in(0xFFFEU), 0x10003U), 5U);
    EXPECT_EQ(age_frames(touched_in(0xFFFFFFFFU), 4U), 5U);
}

}  // namespace
}  // namespace foverig
