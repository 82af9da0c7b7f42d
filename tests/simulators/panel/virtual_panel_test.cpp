#include "simulators/panel/virtual_panel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "devices/dk2/feature_reports.h"
#include "devices/dk2/input_reports.h"
#include "simulators/dk2/simulated_dk2.h"
#include "simulators/motion/simple_heads.h"

namespace foverig {
namespace {

using std::chrono::milliseconds;

HostTime at_ms(double ms) {
    return HostTime(from_seconds(1e-3 * ms));
}

TEST(VirtualPanel, VsyncsAt75HzWithoutDrift) {
    const VirtualPanel panel;
    EXPECT_EQ(panel.vsync(0), HostTime{});
    EXPECT_EQ(panel.vsync(75 * 3600), HostTime(std::chrono::hours(1)));
    EXPECT_EQ(panel.next_vsync(at_ms(13.0)), panel.vsync(1));
    EXPECT_EQ(panel.next_vsync(panel.vsync(1)), panel.vsync(1));
    EXPECT_EQ(panel.next_vsync(panel.vsync(1) + Nanoseconds(1)), panel.vsync(2));
}

TEST(VirtualPanel, ShowsAFrameFromTheVsyncItMakes) {
    VirtualPanel panel;
    const Presentation early = panel.present({.frame_id = 1}, at_ms(13.3));
    EXPECT_EQ(early.vsync_number, 1u);
    const Presentation late = panel.present({.frame_id = 2}, at_ms(26.7));  // vsync 2 was at 26.667
    EXPECT_EQ(late.vsync_number, 3u);
    EXPECT_EQ(late.vsync, panel.vsync(3));
    EXPECT_EQ(panel.counts().repeated, 1u);  // vsync 2 showed frame 1 again
    EXPECT_EQ(panel.counts().presented, 2u);
}

TEST(VirtualPanel, ASecondFrameForOneVsyncReplacesTheFirst) {
    VirtualPanel panel;
    EXPECT_FALSE(panel.present({.frame_id = 1}, at_ms(2.0)).replaced);
    EXPECT_TRUE(panel.present({.frame_id = 2}, at_ms(3.0)).replaced);
    const auto lights = panel.lights(960.0, at_ms(0.0), at_ms(26.0));
    ASSERT_EQ(lights.size(), 1u);
    EXPECT_EQ(lights[0].frame_id, 2u);
}

// DEVICES.md 2.3: 1933 rows a period, 435 of them lit; the right eye's edge first.
TEST(VirtualPanel, LightRollsFromRightToLeft) {
    VirtualPanel panel;
    panel.present({.frame_id = 1}, at_ms(1.0));
    const auto right = panel.lights(1920.0, at_ms(0.0), at_ms(40.0));
    const auto left = panel.lights(0.0, at_ms(0.0), at_ms(40.0));
    ASSERT_EQ(right.size(), 2u);
    const HostTime vsync = panel.vsync(1);
    const double row_ms = 1000.0 / 75.0 / 1933.0;
    EXPECT_NEAR(to_ms(right[0].from - vsync), 0.0273 + 0.1, 1e-5);
    EXPECT_NEAR(to_ms(left[0].from - right[0].from), 1920.0 * row_ms, 1e-5);
    EXPECT_NEAR(to_ms(right[0].to - right[0].from), 435.0 * row_ms, 1e-5);
    // The middle of the light is where the timing says that the photon is.
    EXPECT_NEAR(
        to_ms(left[0].from + (left[0].to - left[0].from) / 2 - panel.timing().photon(vsync, 0.0)),
        0.0, 1e-5);
}

TEST(VirtualPanel, IsDarkBetweenFlashesAndLitThroughoutAt60Hz) {
    const auto lit_share = [](const PanelTiming& timing) {
        VirtualPanel panel({.timing = timing});
        panel.present({.frame_id = 1}, at_ms(1.0));
        double lit_ms = 0.0;
        for (const auto& light : panel.lights(500.0, at_ms(100.0), at_ms(1100.0))) {
            lit_ms += to_ms(light.to - light.from);
        }
        return lit_ms / 1000.0;
    };
    EXPECT_NEAR(lit_share(PanelTiming{}), 435.0 / 1933.0, 1e-3);
    EXPECT_NEAR(lit_share(PanelTiming::at(60.0)), 1.0, 1e-3);
}

TEST(VirtualPanel, ReadsBackOneFrameLate) {
    VirtualPanel panel;
    panel.present({.frame_id = 1, .latency_level = 48}, at_ms(1.0));   // vsync 1
    panel.present({.frame_id = 2, .latency_level = 80}, at_ms(14.0));  // vsync 2
    const auto reading = panel.reading_at(panel.vsync(2) + milliseconds(1), true);
    ASSERT_TRUE(reading);
    EXPECT_EQ(reading->frame_count, 1);
    EXPECT_EQ(reading->vsync, panel.vsync(1));
    EXPECT_EQ(reading->grey, 48);
    const auto newest = panel.reading_at(panel.vsync(2) + milliseconds(1), false);
    EXPECT_EQ(newest->frame_count, 2);
    EXPECT_FALSE(newest->grey);
    EXPECT_FALSE(panel.reading_at(HostTime(Nanoseconds(-1)), false));
}

TEST(VirtualPanel, LostReadsLeaveAnEarlierTripleStanding) {
    VirtualPanel panel({.faults = {.lost_readback = 0.2}, .seed = 3});
    int lost = 0;
    for (std::uint64_t n = 30; n < 2030; ++n) {
        const auto reading = panel.reading_at(panel.vsync(n), true);
        ASSERT_TRUE(reading);
        ASSERT_LT(reading->frame_count, n);
        lost += reading->frame_count != n - 1 ? 1 : 0;
    }
    EXPECT_NEAR(lost / 2000.0, 0.2, 4.0 * std::sqrt(0.2 * 0.8 / 2000.0));
}

TEST(VirtualPanel, JitterMovesVsyncsByItsSigma) {
    const VirtualPanel panel({.faults = {.vsync_jitter = 50.0}, .seed = 1}), exact;
    double square = 0.0;
    for (std::uint64_t n = 0; n < 5000; ++n) {
        const double us = 1e3 * to_ms(panel.vsync(n) - exact.vsync(n));
        square += us * us;
        if (n > 0) {
            ASSERT_EQ(panel.next_vsync(panel.vsync(n - 1) + Nanoseconds(1)), panel.vsync(n));
        }
    }
    EXPECT_NEAR(std::sqrt(square / 5000.0), 50.0, 2.0);
}

TEST(VirtualPanel, ReachesReportElevenThroughTheHeadset) {
    ManualClock clock;
    const motion::StillHead still;
    VirtualPanel panel;
    SimulatedDk2 device(clock, still, {.panel = &panel});
    ASSERT_TRUE(device.control_set(13, 0, dk2::DisplayReport{.read_pixel = true}.encode()));
    panel.present({.frame_id = 1, .latency_level = 112}, at_ms(5.0));
    dk2::InputReport11 last;
    while (true) {
        const auto next = device.next(at_ms(30.0));
        const auto* packet = std::get_if<Packet>(&next);
        if (packet == nullptr) break;
        last = *dk2::InputReport11::decode(packet->bytes);
    }
    EXPECT_EQ(last.frame_count, 1);
    EXPECT_EQ(last.frame_id, 112);
    EXPECT_EQ(last.frame_timestamp_us, 2'000'000u + 13'333u);
}

}  // namespace
}  // namespace foverig
