// What each fault of faults.gaze does to the packets.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "devices/gaze/gaze_sample.h"
#include "tests/simulators/gaze/gaze_bench.h"

namespace foverig {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using test::at;
using test::GazeBench;
namespace request = gaze::request;

SimulatedGaze::Settings with(const char* kind, double value, std::uint64_t seed = 0) {
    FaultSettings faults;
    EXPECT_TRUE(set_fault(faults, "gaze", kind, value));
    return {.faults = faults.gaze, .seed = seed};
}

TEST(SimulatedGaze, DropoutIsAGapInTheSequence) {
    GazeBench tracker(with("dropout", 0.05));
    ASSERT_TRUE(tracker.order(request::set_rate, 250));
    ASSERT_TRUE(tracker.order(request::start));
    const auto samples = tracker.samples_until(at(seconds(20)));
    const double lost = 1.0 - static_cast<double>(samples.size()) /
                                  static_cast<double>(samples.back().frame.camera_frame);
    EXPECT_NEAR(lost, 0.05, 4.0 * std::sqrt(0.05 * 0.95 / 5000.0));
    EXPECT_GT(samples.back().frame.header.sequence, samples.size());
}

TEST(SimulatedGaze, LostExposureIsAGapInTheCameraFrames) {
    GazeBench tracker(with("lost_exposure", 0.05));
    ASSERT_TRUE(tracker.order(request::start));
    const auto samples = tracker.samples_until(at(milliseconds(999)));
    EXPECT_LT(samples.size(), samples.back().frame.camera_frame);
    EXPECT_EQ(samples.back().frame.header.sequence + 1, samples.size());
}

TEST(SimulatedGaze, SpoiltFramesFailTheirCrc) {
    GazeBench tracker(with("crc_error", 0.1));
    ASSERT_TRUE(tracker.order(request::set_rate, 250));
    ASSERT_TRUE(tracker.order(request::start));
    const auto samples = tracker.samples_until(at(seconds(10)));
    EXPECT_NEAR(tracker.broken, 250, 60);
    EXPECT_NEAR(static_cast<double>(samples.size()), 2250.0, 60.0);
}

TEST(SimulatedGaze, DuplicatesAreTheSameBytesTwice) {
    GazeBench tracker(with("duplicate", 0.1));
    ASSERT_TRUE(tracker.order(request::start));
    const auto packets = tracker.packets_until(at(seconds(10)));
    int twice = 0;
    for (std::size_t i = 1; i < packets.size(); ++i)
        twice += packets[i].bytes == packets[i - 1].bytes ? 1 : 0;
    EXPECT_NEAR(twice, 60, 30);
}

TEST(SimulatedGaze, LatencyJitterSpreadsTheQueueingOnly) {
    GazeBench tracker(with("latency_jitter", 1.5));
    ASSERT_TRUE(tracker.order(request::set_rate, 250));
    ASSERT_TRUE(tracker.order(request::start));
    double sum = 0, square = 0;
    const auto samples = tracker.samples_until(at(seconds(10)));
    HostTime before{};
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto& frame = samples[i].frame;
        const double latency_ms =
            1e-6 * static_cast<double>(frame.header.queued_ns - frame.exposure_ns);
        sum += latency_ms;
        square += latency_ms * latency_ms;
        EXPECT_GE(samples[i].at, before);
        EXPECT_LE(latency_ms, 31.0);
        before = samples[i].at;
        ASSERT_EQ(frame.exposure_ns, 1'000'000'000'000u + 4'000'000u * (i + 1));
    }
    const double n = static_cast<double>(samples.size()), mean = sum / n;
    EXPECT_NEAR(mean, 12.1, 0.2);
    EXPECT_NEAR(std::sqrt(square / n - mean * mean), 1.5, 0.15);
}

TEST(SimulatedGaze, TheClockJumpsOnceAndSaysSo) {
    GazeBench tracker(with("time_jump", 500.0));
    ASSERT_TRUE(tracker.order(request::start));
    int resets = 0;
    std::uint64_t before = 0;
    for (const auto& [arrival, frame] : tracker.samples_until(at(seconds(10)))) {
        resets += (frame.header.flags & gaze::frame_flag::clock_reset) != 0 ? 1 : 0;
        if (before != 0 && frame.exposure_ns - before > 100'000'000u) {
            EXPECT_NEAR(static_cast<double>(frame.exposure_ns - before), 5e8 + 1e9 / 60.0, 10.0);
        }
        before = frame.exposure_ns;
    }
    EXPECT_LE(resets, 1);  // the flag may fall to a heartbeat
    EXPECT_NEAR(static_cast<double>(before), 1e12 + 1e10 - 0.016e9 + 0.5e9, 0.03e9);
}

TEST(SimulatedGaze, ClockDriftSpeedsCamerasAndStamps) {
    GazeBench tracker(with("clock_drift", 1000.0));
    ASSERT_TRUE(tracker.order(request::start));
    const auto samples = tracker.samples_until(at(milliseconds(10015)));
    EXPECT_EQ(samples.size(), 600u);
    // On its own clock the tracker exposes at exactly 60 Hz.
    EXPECT_NEAR(static_cast<double>(samples[599].frame.exposure_ns), 1e12 + 1e10, 100.0);
    EXPECT_NEAR(to_ms(samples[599].at.time_since_epoch()), 1e4 / 1.001 + 13.0, 1e-3);
}

TEST(SimulatedGaze, TakesOrdersForFaults) {
    GazeBench tracker;
    ASSERT_TRUE(tracker.order(request::start));
    (void)tracker.samples_until(at(seconds(1)));
    const auto send = [&](gaze::FaultKind kind, std::uint16_t count, std::uint32_t ms) {
        return tracker.order(
            request::sim_fault, 0,
            gaze::SimFault{.kind = kind, .count = count, .duration_ms = ms}.encode());
    };
    ASSERT_TRUE(send(gaze::FaultKind::drop_frame, 3, 0));
    ASSERT_TRUE(send(gaze::FaultKind::crc_error, 5, 0));
    const auto after = tracker.samples_until(at(milliseconds(1990)));
    EXPECT_EQ(tracker.broken, 2);  // three of the five were dropped before
    EXPECT_NEAR(static_cast<double>(after.size()), 60.0 - 5.0, 1.0);
    ASSERT_TRUE(send(gaze::FaultKind::eye_lost, 0, 200));
    int invalid = 0;
    for (const auto& arrived : tracker.samples_until(at(milliseconds(2900)))) {
        invalid += (arrived.frame.status & 1) == 0 ? 1 : 0;
    }
    EXPECT_EQ(invalid, 12);
    EXPECT_FALSE(send(static_cast<gaze::FaultKind>(10), 1, 0));
}

Status order(GazeBench& tracker, const gaze::SimFault& fault) {
    return tracker.order(request::sim_fault, 0, fault.encode());
}

TEST(SimulatedGaze, BlinksWhenOrdered) {
    GazeBench tracker;
    ASSERT_TRUE(tracker.order(request::start));
    (void)tracker.samples_until(at(milliseconds(990)));
    ASSERT_TRUE(order(tracker, {.kind = gaze::FaultKind::blink, .duration_ms = 200}));
    int blinks = 0;
    for (const auto& arrived : tracker.samples_until(at(seconds(2)))) {
        const bool shut = (arrived.frame.status & gaze::sample_status::left_blink) != 0;
        blinks += shut ? 1 : 0;
        EXPECT_EQ(shut, arrived.frame.left.cause == gaze::EyeCause::blink);
        EXPECT_EQ(shut, arrived.frame.left.openness == 0.0F);
    }
    EXPECT_EQ(blinks, 12);
}

// DEVICES.md 4.5.3, rule (f): one eye at 3, and the combined ray is that eye's.
TEST(SimulatedGaze, BlinksWithOneEyeWhenOrdered) {
    namespace status = gaze::sample_status;
    for (const bool left : {true, false}) {
        GazeBench tracker;
        ASSERT_TRUE(tracker.order(request::start));
        (void)tracker.samples_until(at(milliseconds(990)));
        ASSERT_TRUE(
            order(tracker,
                  {.kind = gaze::FaultKind::blink, .p1 = left ? 1.0F : 2.0F, .duration_ms = 200}));
        int blinks = 0;
        for (const auto& arrived : tracker.samples_until(at(seconds(2)))) {
            const auto& frame = arrived.frame;
            const auto& lid = left ? frame.left : frame.right;
            const auto& other = left ? frame.right : frame.left;
            const std::uint16_t of_lid = left ? status::left_blink : status::right_blink;
            const bool shut = (frame.status & (status::left_blink | status::right_blink)) != 0;
            EXPECT_EQ(other.state, gaze::EyeState::tracked);
            if (!shut) continue;
            ++blinks;
            EXPECT_EQ(frame.status, status::valid | status::combined_valid | of_lid |
                                        (left ? status::right_valid : status::left_valid));
            EXPECT_EQ(lid.state, gaze::EyeState::invalid);
            EXPECT_EQ(lid.cause, gaze::EyeCause::blink);
            EXPECT_EQ(lid.openness, 0.0F);
            EXPECT_EQ(frame.direction, other.direction);
            EXPECT_EQ(frame.base_point_mm, other.base_point_mm);
            EXPECT_GE(frame.por_px[0], 0.0F);
            EXPECT_LT(frame.por_px[0], 960.0F);
            EXPECT_TRUE(std::isnan(frame.vergence_distance_mm));
            const GazeSample sample = to_sample(frame);
            EXPECT_EQ(sample.left.ray.valid, !left);
            EXPECT_EQ(sample.right.ray.valid, left);
            EXPECT_TRUE(sample.combined.valid);
        }
        EXPECT_EQ(blinks, 12);
        EXPECT_FALSE(order(tracker, {.kind = gaze::FaultKind::blink, .p1 = 3.0F}));
    }
}

TEST(SimulatedGaze, StallsAsManyRequestsAsOrdered) {
    GazeBench tracker;
    ASSERT_TRUE(order(tracker, {.kind = gaze::FaultKind::stall, .count = 2}));
    EXPECT_EQ(tracker.order(request::start).error().code, ErrorCode::unsupported);
    EXPECT_FALSE(tracker.device.control_get(request::get_info, 0, gaze::Info::kSize));
    EXPECT_TRUE(tracker.device.control_get(request::get_info, 0, gaze::Info::kSize));
}

TEST(SimulatedGaze, IsUnpluggedWhenOrderedAndComesBackIdle) {
    GazeBench tracker;
    ASSERT_TRUE(tracker.order(request::start));
    tracker.clock.sleep_until(at(seconds(1)));
    ASSERT_TRUE(order(tracker, {.kind = gaze::FaultKind::unplug, .duration_ms = 500}));
    EXPECT_EQ(tracker.order(request::start).error().code, ErrorCode::closed);
    while (std::holds_alternative<Packet>(tracker.device.next(at(milliseconds(1400))))) {
    }
    tracker.clock.sleep_until(at(milliseconds(1600)));
    EXPECT_TRUE(tracker.order(request::start)) << "idle";
}

/// At each 0.1 s, asked just after it: '.' plugged in, 'x' not.
std::string plugged(GazeBench& tracker, int from_ms, int until_ms) {
    std::string seen;
    for (int ms = from_ms; ms < until_ms; ms += 100) {
        const HostTime now = at(milliseconds(ms + 5));
        tracker.clock.sleep_until(now);
        (void)tracker.packets_until(now);
        seen += std::holds_alternative<Fault>(tracker.device.next(now)) ? 'x' : '.';
    }
    return seen;
}

TEST(SimulatedGaze, AnOrderedUnplugLeavesTheScheduledOneStanding) {
    auto settings = with("unplug_at", 1.0);
    settings.faults.unplug_for = 0.3;
    GazeBench apart(settings);
    EXPECT_EQ(plugged(apart, 0, 400), "....");
    ASSERT_TRUE(order(apart, {.kind = gaze::FaultKind::unplug, .duration_ms = 200}));
    EXPECT_EQ(plugged(apart, 400, 1600), "x.....xxx...");
    GazeBench overlapping(settings);
    EXPECT_EQ(plugged(overlapping, 0, 900), ".........");
    ASSERT_TRUE(order(overlapping, {.kind = gaze::FaultKind::unplug, .duration_ms = 200}));
    EXPECT_EQ(plugged(overlapping, 900, 1600), "xxxx...");
    GazeBench around(settings);
    EXPECT_EQ(plugged(around, 0, 900), ".........");
    ASSERT_TRUE(order(around, {.kind = gaze::FaultKind::unplug, .duration_ms = 600}));
    EXPECT_EQ(plugged(around, 900, 1900), "xxxxx.....");
}

TEST(SimulatedGaze, DriftsFromTheOrderOn) {
    GazeBench tracker;
    ASSERT_TRUE(tracker.order(request::start));
    const auto before = tracker.samples_until(at(seconds(10)));
    ASSERT_TRUE(order(tracker, {.kind = gaze::FaultKind::clock_drift, .p1 = 1000}));
    const auto after = tracker.samples_until(at(seconds(20)));
    ASSERT_GT(after.size(), 500u);
    // The cameras run on the device's clock: 60 Hz by its stamps, 60.06 by ours, without a jump.
    const auto spacing_ms = [](const auto& a, const auto& b) { return to_ms(b.at - a.at); };
    EXPECT_NEAR(spacing_ms(before.back(), after.front()), 1000.0 / 60.0, 0.02);
    EXPECT_NEAR(spacing_ms(after[10], after[510]), 500 * 1000.0 / 60.06, 1e-3);
    EXPECT_NEAR(static_cast<double>(after[510].frame.exposure_ns - after[10].frame.exposure_ns),
                500e9 / 60.0, 100.0);
    EXPECT_FALSE(order(tracker, {.kind = gaze::FaultKind::clock_drift,
                                 .p1 = std::numeric_limits<float>::quiet_NaN()}));
}

TEST(SimulatedGaze, UnpluggedIsAFault) {
    auto settings = with("unplug_at", 1.0);
    settings.faults.unplug_for = 1.0;
    GazeBench tracker(settings);
    ASSERT_TRUE(tracker.order(request::start));
    EXPECT_GT(tracker.packets_until(at(milliseconds(1500))).size(), 50u);
    tracker.clock.sleep_until(at(milliseconds(1500)));
    EXPECT_TRUE(std::holds_alternative<Fault>(tracker.device.next(at(milliseconds(1500)))));
    EXPECT_EQ(tracker.order(request::start).error().code, ErrorCode::closed);
    tracker.clock.sleep_until(at(milliseconds(2100)));
    EXPECT_TRUE(tracker.order(request::start));  // plugged in again, idle
}

TEST(SimulatedGaze, SameSeedGivesTheSameBytes) {
    auto settings = with("noise", 0.12, 3);
    settings.faults.blink = 30.0;
    settings.faults.latency_jitter = 1.5;
    GazeBench a(settings), b(settings);
    settings.seed = 4;
    GazeBench c(settings);
    for (GazeBench* t : {&a, &b, &c}) ASSERT_TRUE(t->order(request::start));
    const auto pa = a.packets_until(at(seconds(5)));
    std::vector<Packet> pb;
    for (int ms = 7; ms < 5007; ms += 7) {
        for (auto& p : b.packets_until(at(milliseconds(std::min(ms, 5000))))) pb.push_back(p);
    }
    const auto pc = c.packets_until(at(seconds(5)));
    ASSERT_EQ(pa.size(), pb.size());
    for (std::size_t i = 0; i < pa.size(); ++i) {
        ASSERT_EQ(pa[i].arrival, pb[i].arrival);
        ASSERT_EQ(pa[i].bytes, pb[i].bytes);
    }
    EXPECT_NE(pa[9].bytes, pc[9].bytes);
}

}  // namespace
}  // namespace foverig
