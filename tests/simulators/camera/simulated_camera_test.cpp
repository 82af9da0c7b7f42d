#include <cmath>

#include "devices/dk2/led_reports.h"
#include "simulators/dk2/led_table.h"
#include "tests/simulators/camera/camera_bench.h"

namespace foverig {
namespace {

using test::at_s;
using test::CameraBench;

struct Seen {
    std::vector<HostTime> stamps;
    std::vector<std::uint32_t> sequence;
};

Seen frames_until(CameraBench& bench, double until_s) {
    Seen seen;
    while (true) {
        const auto next = bench.device.next(at_s(until_s));
        const auto* packet = std::get_if<Packet>(&next);
        if (packet == nullptr) return seen;
        const auto header = camera::decode_header(packet->bytes);
        EXPECT_TRUE(header);
        seen.sequence.push_back(header->sequence);
        seen.stamps.push_back(packet->arrival - std::chrono::microseconds(header->age_us));
        EXPECT_LE(packet->arrival, at_s(until_s));
    }
}

void light_leds(CameraBench& bench) {
    const dk2::TrackingReport blinking{
        .enable = true, .exposure_us = 350, .frame_interval_us = 16666};
    ASSERT_TRUE(bench.dk2.control_set(dk2::TrackingReport::kId, 0, blinking.encode()));
}

TEST(SimulatedCamera, TakesAFrameOfEachFlashOnceItIsSetUp) {
    CameraBench bench;
    light_leds(bench);
    camera::Esp570 bridge(bench.device);
    ASSERT_TRUE(camera::set_up_sensor(bridge, camera::Sync::headset));
    const Seen seen = frames_until(bench, 1.0);
    ASSERT_EQ(seen.stamps.size(), 59u);  // flash 59 is read out after 999.4 ms
    for (std::size_t i = 0; i < seen.stamps.size(); ++i) {
        const double late_us = 1e6 * to_seconds(seen.stamps[i].time_since_epoch()) -
                               16666.0 * static_cast<double>(i + 1);
        EXPECT_NEAR(late_us, 353 + 300, 2.0);
        EXPECT_EQ(seen.sequence[i], i);
    }
}

// DEVICES.md 1.8.2: with a vertical blank of 57 every second pulse comes while a frame is read out.
TEST(SimulatedCamera, HasHalfTheRateWithTooLongABlank) {
    CameraBench bench;
    light_leds(bench);
    camera::Esp570 bridge(bench.device);
    ASSERT_TRUE(camera::set_up_sensor(bridge, camera::Sync::headset));
    ASSERT_TRUE(
        bridge.write_register(camera::i2c::kSensor, camera::mt9v034::kRegVerticalBlank, 57));
    EXPECT_NEAR(static_cast<double>(frames_until(bench, 2.0).stamps.size()), 60.0, 1.0);
}

TEST(SimulatedCamera, RunsFreelyUntilItIsSetUp) {
    CameraBench bench;
    EXPECT_NEAR(static_cast<double>(frames_until(bench, 2.0).stamps.size()), 2 / 0.017041, 1.5);
}

TEST(SimulatedCamera, SeesNothingOfAHeadsetThatFellAsleep) {
    CameraBench bench;
    light_leds(bench);
    camera::Esp570 bridge(bench.device);
    ASSERT_TRUE(camera::set_up_sensor(bridge, camera::Sync::headset));
    EXPECT_NEAR(static_cast<double>(frames_until(bench, 15.0).stamps.size()), 600.0, 2.0);
}

// DEVICES.md 1.5: report 15 counts through 41 points, 16 through 40 patterns.
TEST(LedReports, TheHeadsetTellsItsTable) {
    CameraBench bench;
    ASSERT_EQ(bench.leds.size(), kLedTable.size());
    EXPECT_NEAR(bench.leds[0].position_m.x, 0.027362 + 0.067100, 1e-9);
    EXPECT_NEAR(bench.leds[0].position_m.y, -0.048634 + 0.024100, 1e-9);
    EXPECT_NEAR(bench.leds[0].position_m.z, 0.022830 + 0.008545, 1e-9);
    EXPECT_LT(bench.leds[20].normal.z, -0.99);
    for (std::size_t i = 0; i < bench.leds.size(); ++i) {
        EXPECT_EQ(bench.leds[i].code, kLedTable[i].code);
        EXPECT_NEAR(glm::length(bench.leds[i].normal), 1.0, 1e-12);
    }
    // The device went one further than a whole round; another round gives the same.
    const auto again = dk2::read_leds(bench.dk2);
    ASSERT_TRUE(again);
    for (std::size_t i = 0; i < bench.leds.size(); ++i) {
        EXPECT_EQ((*again)[i].position_m, bench.leds[i].position_m);
    }
}

}  // namespace
}  // namespace foverig
