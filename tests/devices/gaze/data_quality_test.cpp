#include "devices/gaze/data_quality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "devices/gaze_angles.h"

namespace foverig::gaze {
namespace {

TEST(DataQuality, OfAConstantOffsetIsThatOffset) {
    DataQualityMeter meter;
    for (int i = 0; i < 10; ++i) meter.add(gaze_direction({0.0, 3.0}));
    const DataQuality q = meter.against(gaze_direction({0.0, 1.0}));
    EXPECT_EQ(q.samples, 10U);
    EXPECT_NEAR(q.accuracy_deg, 2.0, 1e-12);
    EXPECT_NEAR(q.rms_s2s_deg, 0.0, 1e-6);
    EXPECT_NEAR(q.sd_deg, 0.0, 1e-6);
}

TEST(DataQuality, OfAHopFromSideToSide) {
    // Every step is 2 degrees, every sample 1 degree from the mean and from the target.
    DataQualityMeter meter;
    for (int i = 0; i < 10; ++i) meter.add(gaze_direction({0.0, i % 2 == 0 ? 1.0 : -1.0}));
    const DataQuality q = meter.against(gaze_direction({0.0, 0.0}));
    EXPECT_NEAR(q.accuracy_deg, 1.0, 1e-12);
    EXPECT_NEAR(q.rms_s2s_deg, 2.0, 1e-12);
    EXPECT_NEAR(q.sd_deg, 1.0, 1e-12);
}

// RMS-S2S^2 = 2 SD^2 (1 - rho) with the lag-1 autocorrelation rho (DEVICES.md 5.5); of a circle of
// k steps rho is cos(2 pi / k).
TEST(DataQuality, KeepsTheIdentityOfItsTwoPrecisions) {
    constexpr int kSteps = 12;
    DataQualityMeter meter;
    for (int i = 0; i < 50 * kSteps; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / kSteps;
        meter.add(gaze_direction({0.2 * std::cos(turn), 0.2 * std::sin(turn)}));
    }
    const DataQuality q = meter.against(gaze_direction({0.0, 0.0}));
    const double rho = std::cos(2.0 * std::numbers::pi / kSteps);
    EXPECT_NEAR(q.sd_deg, 0.2, 1e-5);
    EXPECT_NEAR(q.rms_s2s_deg, q.sd_deg * std::sqrt(2.0 * (1.0 - rho)), 1e-5);
}

TEST(DataQuality, CountsNoStepAcrossAGap) {
    DataQualityMeter meter;
    meter.add(gaze_direction({0.0, 0.0}));
    meter.add(gaze_direction({0.0, 1.0}));
    meter.gap();
    meter.add(gaze_direction({0.0, 20.0}));
    meter.add(gaze_direction({0.0, 21.0}));
    EXPECT_NEAR(meter.against(gaze_direction({0.0, 0.0})).rms_s2s_deg, 1.0, 1e-12);
}

TEST(DataQuality, IsUnknownWithoutSamples) {
    DataQualityMeter meter;
    EXPECT_TRUE(std::isnan(meter.against({0, 0, -1}).accuracy_deg));
    meter.add({0, 0, -1});
    EXPECT_EQ(meter.against({0, 0, -1}).accuracy_deg, 0.0);
    EXPECT_TRUE(std::isnan(meter.against({0, 0, -1}).rms_s2s_deg));
    const DataQuality mean = mean_of({meter.against({0, 0, -1}), DataQuality{}});
    EXPECT_EQ(mean.samples, 1U);
    EXPECT_EQ(mean.accuracy_deg, 0.0);
    EXPECT_TRUE(std::isnan(mean.sd_deg));
}

}  // namespace
}  // namespace foverig::gaze
