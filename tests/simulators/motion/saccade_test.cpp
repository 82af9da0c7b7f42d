#include "simulators/motion/saccade.h"

#include <gtest/gtest.h>

#include <cmath>

namespace foverig::motion {
namespace {

struct Row {
    double amplitude_deg, peak_deg_s, duration_ms, ratio;
};
// The table of DEVICES.md 5.1, with its number of digits. It prints 1.37 for V D / A at 0.5
// degrees, where its own formulas give 1.378.
constexpr Row kTable[] = {{0.25, 15, 22.6, 1.36}, {0.5, 30, 23.2, 1.378}, {1, 58, 24.4, 1.41},
                          {2, 109, 26.8, 1.46},   {5, 231, 34, 1.57},     {10, 360, 46, 1.65},
                          {15, 431, 58, 1.67},    {20, 471, 70, 1.65},    {30, 505, 94, 1.58},
                          {40, 515, 118, 1.52}};

TEST(MainSequence, GivesTheDocumentedTable) {
    for (const Row& row : kTable) {
        const double peak = saccade_peak_deg_s(row.amplitude_deg);
        const double duration_s = saccade_duration_s(row.amplitude_deg);
        EXPECT_NEAR(peak, row.peak_deg_s, 0.51) << row.amplitude_deg;
        EXPECT_NEAR(1e3 * duration_s, row.duration_ms, 0.051) << row.amplitude_deg;
        EXPECT_NEAR(peak * duration_s / row.amplitude_deg, row.ratio, 0.0051) << row.amplitude_deg;
    }
}

TEST(SaccadeProfile, KeepsAmplitudePeakAndPeakTime) {
    for (const Row& row : kTable) {
        const SaccadeProfile saccade(row.amplitude_deg);
        double peak = 0.0, peak_s = 0.0, way = 0.0;
        constexpr int kSteps = 20000;
        const double step_s = saccade.duration_s() / kSteps;
        for (int i = 0; i < kSteps; ++i) {
            const double t = (i + 0.5) * step_s;
            const double rate = row.amplitude_deg * saccade.rate_per_s(t);
            way += rate * step_s;
            if (rate > peak) {
                peak = rate;
                peak_s = t;
            }
        }
        EXPECT_NEAR(way, row.amplitude_deg, 1e-5 * row.amplitude_deg);
        EXPECT_NEAR(peak, saccade_peak_deg_s(row.amplitude_deg), 1e-3 * peak);
        const double expected_s = saccade.duration_s() * (0.45 - 0.0015 * row.amplitude_deg);
        EXPECT_NEAR(peak_s, expected_s, 1e-3 * saccade.duration_s());
    }
}

TEST(SaccadeProfile, ProgressIsTheIntegralOfTheRate) {
    const SaccadeProfile saccade(12.0);
    double way = 0.0;
    constexpr double kStep_s = 1e-6;
    for (double t = 0.0; t < saccade.duration_s(); t += kStep_s) {
        EXPECT_NEAR(saccade.progress(t), way, 2e-5);
        way += kStep_s * saccade.rate_per_s(t + 0.5 * kStep_s);
    }
    EXPECT_EQ(saccade.progress(-1.0), 0.0);
    EXPECT_EQ(saccade.progress(saccade.duration_s()), 1.0);
}

}  // namespace
}  // namespace foverig::motion
