#include "simulators/gaze/simulated_gaze.h"

#include <gtest/gtest.h>

#include "tests/simulators/gaze/gaze_bench.h"

namespace foverig {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using test::at;
using test::GazeBench;
namespace request = gaze::request;

TEST(SimulatedGaze, IsIdleUntilStarted) {
    GazeBench tracker;
    EXPECT_TRUE(tracker.packets_until(at(seconds(1))).empty());
    ASSERT_TRUE(tracker.order(request::start));
    EXPECT_FALSE(tracker.packets_until(at(seconds(2))).empty());
    ASSERT_TRUE(tracker.order(request::stop));
    EXPECT_TRUE(tracker.packets_until(at(seconds(3))).empty());
}

class EveryRate : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Rates, EveryRate, testing::Values(60, 120, 250));

TEST_P(EveryRate, StreamsTheTruthOnScheduleWithoutFaults) {
    GazeBench tracker;
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
    GazeBench tracker;
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
    GazeBench tracker;
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
    GazeBench tracker;
    EXPECT_FALSE(tracker.order(request::set_rate, 90));
    EXPECT_FALSE(tracker.order(request::cal_start, 5));
    EXPECT_FALSE(tracker.order(request::reset, 0));
    EXPECT_FALSE(tracker.device.control_get(request::get_info, 0, 63));
    EXPECT_FALSE(tracker.device.control_get(0x55, 0, 4));
    ASSERT_TRUE(tracker.order(request::start));
    ASSERT_TRUE(tracker.order(request::reset, gaze::kResetKey));
    EXPECT_TRUE(tracker.packets_until(at(seconds(1))).empty());  // idle again
}

}  // namespace
}  // namespace foverig
