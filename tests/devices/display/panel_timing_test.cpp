#include "devices/display/panel_timing.h"

#include <gtest/gtest.h>

namespace foverig {
namespace {

constexpr HostTime kVsync{Nanoseconds{1'000'000'000}};

double after_ms(HostTime t) {
    return to_ms(t - kVsync);
}

// Numbers of DEVICES.md 2.3.
TEST(PanelTiming, RowsOfTheFirmwareAt75Hz) {
    const PanelTiming timing = PanelTiming::at(75);
    EXPECT_NEAR(to_ms(timing.period()), 13.333, 1e-3);
    EXPECT_NEAR(to_ms(timing.scan_out()), 13.243, 1e-3);
    EXPECT_NEAR(to_ms(timing.persistence()), 3.0, 1e-2);
}

TEST(PanelTiming, RightEdgeFirstLeftEdgeLast) {
    const PanelTiming timing = PanelTiming::at(75);
    EXPECT_NEAR(after_ms(timing.written(kVsync, 1920)), 0.0273, 1e-6);
    EXPECT_NEAR(after_ms(timing.written(kVsync, 960)), 0.0273 + 13.243 / 2, 1e-3);
    EXPECT_NEAR(after_ms(timing.written(kVsync, 0)), 0.0273 + 13.243, 1e-3);
    EXPECT_LT(timing.written(kVsync, 0), kVsync + timing.period());
}

TEST(PanelTiming, LightsAfterSettlingAroundHalfThePersistence) {
    const PanelTiming timing = PanelTiming::at(75);
    EXPECT_NEAR(to_ms(timing.photon(kVsync, 700) - timing.written(kVsync, 700)), 0.1 + 1.5, 1e-2);
}

TEST(PanelTiming, TheLeftEyeLagsHalfAScan) {
    const PanelTiming timing = PanelTiming::at(75);
    const double right_ms = after_ms(timing.photon(kVsync, Eye::right));
    const double left_ms = after_ms(timing.photon(kVsync, Eye::left));
    EXPECT_NEAR(left_ms - right_ms, 6.6, 0.05);
    EXPECT_NEAR(right_ms, 0.0273 + 13.243 / 4 + 0.1 + 1.5, 1e-2);
}

TEST(PanelTiming, AMeasuredRateIsItsMode) {
    for (const double hz : {74.93, 74.99, 75.0, 75.06}) {
        EXPECT_NEAR(to_ms(PanelTiming::at(hz).persistence()), 3.0, 0.01) << hz;
    }
    EXPECT_NEAR(to_ms(PanelTiming::at(72.04).persistence()), 1000 / 72.04, 1e-3);
}

TEST(PanelTiming, FullPersistenceBelow75Hz) {
    for (const double hz : {60.0, 72.0}) {
        const PanelTiming timing = PanelTiming::at(hz);
        EXPECT_NEAR(to_ms(timing.persistence()), 1000 / hz, 1e-3);
        EXPECT_NEAR(to_ms(timing.scan_out()), 1000 / hz * 1920 / 1933, 1e-3);
    }
}

}  // namespace
}  // namespace foverig
