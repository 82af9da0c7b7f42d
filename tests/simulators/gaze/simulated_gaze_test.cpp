#include "simulators/gaze/simulated_gaze.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <variant>
#include <vector>

#include "simulators/motion/scan_eye.h"

namespace foverig {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
namespace request = gaze::request;

struct Arrived {
    HostTime at;
    gaze::SampleFrame frame;
};

class Tracker {
  public:
    explicit Tracker(const SimulatedGaze::Settings& settings = {})
        : device(clock, scan, settings) {}

    Status order(std::uint8_t id, std::uint16_t value = 0, Bytes data = {}) {
        return device.control_set(id, value, data);
    }
    std::vector<Packet> packets_until(HostTime until) {
        std::vector<Packet> packets;
        while (true) {
            auto next = device.next(until);
            auto* packet = std::get_if<Packet>(&next);
            if (packet == nullptr) return packets;
            packets.push_back(std::move(*packet));
        }
    }
    std::vector<Arrived> samples_until(HostTime until) {
        std::vector<Arrived> samples;
        for (const Packet& packet : packets_until(until)) {
            const auto frame = gaze::decode_frame(packet.bytes);
            if (!frame) {
                ++broken;
            } else if (const auto* sample = std::get_if<gaze::SampleFrame>(&*frame)) {
                samples.push_back({packet.arrival, *sample});
            } else {
                ++heartbeats;
            }
        }
        return samples;
    }

    ManualClock clock;
    motion::ScanEye scan{6};
    SimulatedGaze device;
    int broken = 0, heartbeats = 0;
};

HostTime at(Nanoseconds t) {
    return HostTime(t);
}

SimulatedGaze::Settings with(const char* kind, double value, std::uint64_t seed = 0) {
    FaultSettings faults;
    EXPECT_TRUE(set_fault(faults, "gaze", kind, value));
    return {.faults = faults.gaze, .seed = seed};
}

TEST(SimulatedGaze, IsIdleUntilStarted) {
    Tracker tracker;
    EXPECT_TRUE(tracker.packets_until(at(seconds(1))).empty());
    ASSERT_TRUE(tracker.order(request::start));
    EXPECT_FALSE(tracker.packets_until(at(seconds(2))).empty());
    ASSERT_TRUE(tracker.order(request::stop));
    EXPECT_TRUE(tracker.packets_until(at(seconds(3))).empty());
}

class EveryRate : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Rates, EveryRate, testing::Values(60, 120, 250));

TEST_P(EveryRate, StreamsTheTruthOnScheduleWithoutFaults) {
    Tracker tracker;
    const int rate_hz = GetParam();
    ASSERT_TRUE(tracker.order(request::set_rate, static_cast<std::uint16_t>(rate_hz)));
    ASSERT_TRUE(tracker.order(request::start));
    const auto samples = tracker.samples_until(at(milliseconds(4015)));
    ASSERT_EQ(samples.size(), static_cast<std::size_t>(4 * rate_hz));
    EXPECT_EQ(tracker.heartbeats, 4);
    EXPECT_EQ(tracker.broken, 0);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto& [arrival, frame] = samples[i];
        const HostTime exposed = at(from_seconds(static_cast<double>(i + 1) / rate_hz));
        ASSERT_EQ(arrival, exposed + milliseconds(13));  // 12 ms in the tracker, 1 ms on USB
        ASSERT_EQ(frame.exposure_ns, 1'000'000'000'000u + exposed.time_since_epoch().count());
        ASSERT_EQ(frame.header.queued_ns, frame.exposure_ns + 12'000'000u);
        ASSERT_EQ(frame.camera_frame, i + 1);
        ASSERT_EQ(frame.rate_decihertz, 10 * rate_hz);
        const dvec3 truth = tracker.scan.at(to_seconds(exposed.time_since_epoch())).direction;
        const dvec3 seen(-frame.direction[0], frame.direction[1], -frame.direction[2]);
        ASSERT_LT(glm::distance(seen, truth), 1e-6);
    }
    EXPECT_EQ(samples.front().frame.header.flags,
              gaze::frame_flag::simulated | gaze::frame_flag::discontinuity);
    EXPECT_EQ(samples[1].frame.header.flags, gaze::frame_flag::simulated);
}

TEST(SimulatedGaze, NumbersEachSessionAnew) {
    Tracker tracker;
    ASSERT_TRUE(tracker.order(request::start));
    const auto first = tracker.samples_until(at(milliseconds(500)));
    EXPECT_FALSE(tracker.order(request::start));  // STALL while streaming
    EXPECT_FALSE(tracker.order(request::set_rate, 120));
    ASSERT_TRUE(tracker.order(request::stop));
    ASSERT_TRUE(tracker.order(request::start));
    const auto second = tracker.samples_until(at(seconds(1)));
    EXPECT_EQ(second.front().frame.header.sequence, 0u);
    EXPECT_NE(second.front().frame.header.session, first.front().frame.header.session);
}

TEST(SimulatedGaze, AnswersItsRequests) {
    Tracker tracker;
    const auto info = tracker.device.control_get(request::get_info, 0, gaze::Info::kSize);
    ASSERT_TRUE(info);
    EXPECT_EQ(gaze::Info::decode(*info)->rates, 0b111);
    tracker.clock.advance(milliseconds(250));
    const auto time =
        tracker.device.control_get(request::get_time, 0xBEEF, gaze::DeviceTimeReply::kSize);
    ASSERT_TRUE(time);
    EXPECT_EQ(gaze::DeviceTimeReply::decode(*time)->cookie, 0xBEEF);
    EXPECT_EQ(gaze::DeviceTimeReply::decode(*time)->device_ns, 1'000'250'000'000u);
    ASSERT_TRUE(tracker.order(request::set_mapping, 0, gaze::encode_mapping(900.0f)));
    ASSERT_TRUE(tracker.order(request::set_options, 0, gaze::encode_options(4)));
    ASSERT_TRUE(tracker.order(request::start));
    const auto samples = tracker.samples_until(at(milliseconds(400)));
    EXPECT_EQ(samples.back().frame.mapping_distance_mm, 900.0f);
    EXPECT_TRUE(samples.back().frame.header.flags & gaze::frame_flag::binocular_low_pass);
    const auto bytes =
        tracker.device.control_get(request::get_status, 0, gaze::DeviceStatus::kSize);
    const auto status = gaze::DeviceStatus::decode(*bytes);
    EXPECT_EQ(status->state, gaze::DeviceState::streaming);
    EXPECT_GE(status->sent, samples.size());
    EXPECT_EQ(status->options, 4u);
}

TEST(SimulatedGaze, StallsWhatItDoesNotHave) {
    Tracker tracker;
    EXPECT_FALSE(tracker.order(request::set_rate, 90));
    EXPECT_FALSE(tracker.order(request::cal_start, 5));
    EXPECT_FALSE(tracker.order(request::reset, 0));
    EXPECT_FALSE(tracker.device.control_get(request::get_info, 0, 63));
    EXPECT_FALSE(tracker.device.control_get(0x55, 0, 4));
    ASSERT_TRUE(tracker.order(request::start));
    ASSERT_TRUE(tracker.order(request::reset, gaze::kResetKey));
    EXPECT_TRUE(tracker.packets_until(at(seconds(1))).empty());  // idle again
}

TEST(SimulatedGaze, DropoutIsAGapInTheSequence) {
    Tracker tracker(with("dropout", 0.05));
    ASSERT_TRUE(tracker.order(request::set_rate, 250));
    ASSERT_TRUE(tracker.order(request::start));
    const auto samples = tracker.samples_until(at(seconds(20)));
    const double lost = 1.0 - static_cast<double>(samples.size()) /
                                  static_cast<double>(samples.back().frame.camera_frame);
    EXPECT_NEAR(lost, 0.05, 4.0 * std::sqrt(0.05 * 0.95 / 5000.0));
    EXPECT_GT(samples.back().frame.header.sequence, samples.size());
}

TEST(SimulatedGaze, LostExposureIsAGapInTheCameraFrames) {
    Tracker tracker(with("lost_exposure", 0.05));
    ASSERT_TRUE(tracker.order(request::start));
    const auto samples = tracker.samples_until(at(milliseconds(999)));
    EXPECT_LT(samples.size(), samples.back().frame.camera_frame);
    EXPECT_EQ(samples.back().frame.header.sequence + 1, samples.size());
}

TEST(SimulatedGaze, SpoiltFramesFailTheirCrc) {
    Tracker tracker(with("crc_error", 0.1));
    ASSERT_TRUE(tracker.order(request::set_rate, 250));
    ASSERT_TRUE(tracker.order(request::start));
    const auto samples = tracker.samples_until(at(seconds(10)));
    EXPECT_NEAR(tracker.broken, 250, 60);
    EXPECT_NEAR(static_cast<double>(samples.size()), 2250.0, 60.0);
}

TEST(SimulatedGaze, DuplicatesAreTheSameBytesTwice) {
    Tracker tracker(with("duplicate", 0.1));
    ASSERT_TRUE(tracker.order(request::start));
    const auto packets = tracker.packets_until(at(seconds(10)));
    int twice = 0;
    for (std::size_t i = 1; i < packets.size(); ++i)
        twice += packets[i].bytes == packets[i - 1].bytes ? 1 : 0;
    EXPECT_NEAR(twice, 60, 30);
}

TEST(SimulatedGaze, LatencyJitterSpreadsTheQueueingOnly) {
    Tracker tracker(with("latency_jitter", 1.5));
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
    Tracker tracker(with("time_jump", 500.0));
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
    Tracker tracker(with("clock_drift", 1000.0));
    ASSERT_TRUE(tracker.order(request::start));
    const auto samples = tracker.samples_until(at(milliseconds(10015)));
    EXPECT_EQ(samples.size(), 600u);
    // On its own clock the tracker exposes at exactly 60 Hz.
    EXPECT_NEAR(static_cast<double>(samples[599].frame.exposure_ns), 1e12 + 1e10, 100.0);
    EXPECT_NEAR(to_ms(samples[599].at.time_since_epoch()), 1e4 / 1.001 + 13.0, 1e-3);
}

TEST(SimulatedGaze, TakesOrdersForFaults) {
    Tracker tracker;
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
    EXPECT_FALSE(send(gaze::FaultKind::stall, 1, 0));
}

TEST(SimulatedGaze, UnpluggedIsAFault) {
    auto settings = with("unplug_at", 1.0);
    settings.faults.unplug_for = 1.0;
    Tracker tracker(settings);
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
    Tracker a(settings), b(settings);
    settings.seed = 4;
    Tracker c(settings);
    for (Tracker* t : {&a, &b, &c}) ASSERT_TRUE(t->order(request::start));
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
