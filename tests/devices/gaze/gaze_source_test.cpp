#include "devices/gaze/gaze_source.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/devices/byte_text.h"
#include "tests/devices/fake_transport.h"
#include "tests/devices/gaze/golden_sample.h"

namespace foverig::gaze {
namespace {

using test::copy_of;
using test::FakeTransport;
using test::golden_sample;

constexpr std::uint64_t kDeviceStart_ns = 7'000'000'000'000;
HostTime at_ms(double ms) {
    return HostTime(from_seconds(ms * 1e-3));
}

/// A tracker whose clock is kDeviceStart_ns ahead; GET_TIME takes no time.
struct Tracker {
    ManualClock clock;
    FakeTransport transport;

    Tracker() {
        transport.answer_by = [this](std::uint8_t id,
                                     std::uint16_t value) -> Result<std::vector<std::byte>> {
            if (id == request::get_info) return copy_of(Info{.rates = 0b111}.encode());
            const auto now_ns = static_cast<std::uint64_t>(clock.now().time_since_epoch().count());
            return copy_of(
                DeviceTimeReply{.device_ns = kDeviceStart_ns + now_ns, .cookie = value}.encode());
        };
    }

    GazeSource open(const GazeSourceConfig& config = {}) {
        auto source = GazeSource::open(transport, clock, config);
        EXPECT_TRUE(source) << (source ? "" : source.error().text);
        return std::move(source).value();
    }

    /// Exposed at `ms`, queued 12 ms and arriving 12 + `usb_ms` later.
    void push(std::uint32_t sequence, double ms, double usb_ms = 0.2, std::uint32_t session = 1,
              std::uint8_t flags = 0) {
        SampleFrame f = golden_sample();
        f.header = {.flags = flags,
                    .sequence = sequence,
                    .queued_ns = device_ns(ms + 12),
                    .session = session};
        f.exposure_ns = device_ns(ms);
        f.camera_frame = sequence;
        transport.push(at_ms(ms + 12 + usb_ms), f.encode());
    }

    static std::uint64_t device_ns(double ms) {
        return kDeviceStart_ns + static_cast<std::uint64_t>(std::llround(ms * 1e6));
    }
};

std::optional<GazeSample> sample_of(GazeSource& source) {
    const auto next = source.next(at_ms(1e6));
    const auto* sample = std::get_if<GazeSample>(&next);
    return sample ? std::optional(*sample) : std::nullopt;
}

TEST(GazeSource, StopsSetsUpAndStarts) {
    Tracker tracker;
    tracker.open({.rate_hz = 250, .options = option::disable_por_filter});
    const auto& sets = tracker.transport.sets;
    ASSERT_EQ(sets.size(), 5u);
    EXPECT_EQ(sets[0].id, request::stop);
    EXPECT_EQ(sets[1].id, request::set_rate);
    EXPECT_EQ(sets[1].value, 250);
    EXPECT_EQ(*decode_options(sets[2].data), option::disable_por_filter);
    EXPECT_EQ(*decode_mapping(sets[3].data), 1500);
    EXPECT_EQ(sets[4].id, request::start);
}

TEST(GazeSource, RefusesARateOrVersionThatTheTrackerLacks) {
    Tracker tracker;
    tracker.transport.answer_by = [](std::uint8_t,
                                     std::uint16_t) -> Result<std::vector<std::byte>> {
        return copy_of(Info{.rates = 1}.encode());
    };
    const auto too_fast = GazeSource::open(tracker.transport, tracker.clock, {.rate_hz = 120});
    ASSERT_FALSE(too_fast);
    EXPECT_EQ(too_fast.error().code, ErrorCode::unsupported);
    EXPECT_EQ(too_fast.error().text,
              "the tracker has no rate of 120 Hz; expected one of its own: 60 Hz");
    EXPECT_FALSE(GazeSource::open(tracker.transport, tracker.clock, {.rate_hz = 61}));
    tracker.transport.answer_by = [](std::uint8_t,
                                     std::uint16_t) -> Result<std::vector<std::byte>> {
        return copy_of(Info{.major = 2}.encode());
    };
    EXPECT_FALSE(GazeSource::open(tracker.transport, tracker.clock));
    EXPECT_TRUE(tracker.transport.sets.empty());
}

TEST(GazeSource, TimesSamplesByExposureNotArrival) {
    Tracker tracker;
    GazeSource source = tracker.open();
    test::Random random(1);
    for (std::uint32_t i = 0; i < 600; ++i) tracker.push(i, 16.667 * i, 0.5 + random.uniform());
    for (std::uint32_t i = 0; i < 600; ++i) {
        tracker.clock.sleep_until(at_ms(16.667 * i + 12));
        const auto s = sample_of(source);
        ASSERT_TRUE(s);
        // GET_TIME takes out the constant half millisecond that arrivals alone could not.
        EXPECT_LT(std::abs(to_ms(s->host_time - at_ms(16.667 * i))), 0.1) << i;
        EXPECT_GT(to_ms(s->arrival - s->host_time), 12);
    }
    EXPECT_EQ(source.counts().samples, 600u);
    EXPECT_EQ(source.failed_requests().refused, 0u);
}

TEST(GazeSource, LeavesTheRateAsItIsWhereNoneIsAsked) {
    Tracker tracker;
    tracker.open({.rate_hz = 0});
    EXPECT_EQ(tracker.transport.sets_of(request::set_rate), 0);
    EXPECT_EQ(tracker.transport.sets_of(request::start), 1);
}

/// The transport says of some that it did not even ask (devices/hardware/patience.h).
TEST(GazeSource, CountsRequestsThatWereNotSentApart) {
    Tracker tracker;
    GazeSource source = tracker.open();
    ErrorCode refusal = ErrorCode::io;
    tracker.transport.answer_by = [&](std::uint8_t,
                                      std::uint16_t) -> Result<std::vector<std::byte>> {
        return Error{refusal, "refused by the test"};
    };
    for (int i = 1; i <= 7; ++i) {
        tracker.clock.sleep_until(at_ms(300.0 * i));
        (void)source.next(tracker.clock.now());
        refusal = i < 2 ? ErrorCode::io : ErrorCode::not_asked;
    }
    EXPECT_EQ(source.failed_requests().refused, 2u);
    EXPECT_EQ(source.failed_requests().not_sent, 5u);
}

TEST(GazeSource, CountsLossBySequenceAndFlagsTheGap) {
    Tracker tracker;
    GazeSource source = tracker.open();
    const std::uint32_t sequences[] = {0xFFFFFFFE, 0xFFFFFFFF, 2, 3};
    for (std::size_t i = 0; i < 4; ++i) tracker.push(sequences[i], 17.0 * static_cast<double>(i));
    EXPECT_FALSE(sample_of(source)->gap);
    EXPECT_FALSE(sample_of(source)->gap);
    EXPECT_TRUE(sample_of(source)->gap);
    EXPECT_FALSE(sample_of(source)->gap);
    EXPECT_EQ(source.counts().lost, 2u);
    EXPECT_EQ(source.missed_exposures(), 2u);
}

TEST(GazeSource, DiscardsDamagedForeignDuplicateAndLateTransfers) {
    Tracker tracker;
    GazeSource source = tracker.open();
    tracker.push(5, 0);
    auto damaged = copy_of(golden_sample().encode());
    damaged[100] ^= std::byte{1};
    tracker.transport.push(at_ms(13), damaged);
    tracker.transport.push(at_ms(13), std::vector<std::byte>(248));
    tracker.push(5, 17);
    tracker.push(4, 18);
    tracker.push(6, 34);
    ASSERT_TRUE(sample_of(source));
    const auto s = sample_of(source);
    ASSERT_TRUE(s);
    EXPECT_EQ(s->sequence, 6u);
    EXPECT_EQ(source.counts().rejected, 4u);
    EXPECT_EQ(source.counts().lost, 0u);
}

TEST(GazeSource, AnExposureAfterItsSendingIsNonsense) {
    Tracker tracker;
    GazeSource source = tracker.open();
    SampleFrame f = golden_sample();
    f.exposure_ns = f.header.queued_ns + 1;
    tracker.transport.push(at_ms(1), f.encode());
    f.exposure_ns = f.header.queued_ns = ~std::uint64_t{0};
    tracker.transport.push(at_ms(1), f.encode());
    EXPECT_FALSE(sample_of(source));
    EXPECT_EQ(source.counts().rejected, 2u);
}

TEST(GazeSource, ANewSessionStartsTheSequenceAnew) {
    Tracker tracker;
    GazeSource source = tracker.open();
    tracker.push(1000, 0);
    tracker.push(0, 17, 0.2, 2, frame_flag::discontinuity);
    EXPECT_FALSE(sample_of(source)->gap);
    EXPECT_TRUE(sample_of(source)->gap);
    EXPECT_EQ(source.counts().reconnects, 1u);
    EXPECT_EQ(source.counts().lost, 0u);
}

TEST(GazeSource, AClockSetBackStartsTheMapAnew) {
    Tracker tracker;
    GazeSource source = tracker.open();
    for (std::uint32_t i = 0; i < 100; ++i) tracker.push(i, 17.0 * i);
    SampleFrame f = golden_sample();
    f.header = {.sequence = 100, .queued_ns = 20'000'000, .session = 1};
    f.exposure_ns = 8'000'000;
    tracker.transport.push(at_ms(1720), f.encode());
    for (int i = 0; i < 100; ++i) ASSERT_TRUE(sample_of(source));
    const auto s = sample_of(source);
    ASSERT_TRUE(s);
    EXPECT_EQ(s->host_time, at_ms(1708));
}

TEST(GazeSource, EventsAndCalibrationComeBesideTheSamples) {
    Tracker tracker;
    GazeSource source = tracker.open();
    EventFrame event;
    event.header = {.sequence = 0, .queued_ns = Tracker::device_ns(1), .session = 1};
    event.kind = EventKind::saccade;
    tracker.transport.push(at_ms(1.2), event.encode());
    CalibrationFrame calibration;
    calibration.header = {.sequence = 1, .queued_ns = Tracker::device_ns(2), .session = 1};
    calibration.state = CalibrationState::done;
    tracker.transport.push(at_ms(2.2), calibration.encode());
    tracker.push(2, 3);
    ASSERT_TRUE(sample_of(source));
    const auto events = source.take_events();
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].kind, EventKind::saccade);
    EXPECT_TRUE(source.take_events().empty());
    const auto calibrations = source.take_calibrations();
    ASSERT_EQ(calibrations.size(), 1u);
    EXPECT_EQ(calibrations[0].state, CalibrationState::done);
    EXPECT_TRUE(source.take_calibrations().empty());
    EXPECT_EQ(source.counts().lost, 0u);
}

TEST(GazeSource, SurvivesRandomSealedFrames) {
    Tracker tracker;
    GazeSource source = tracker.open();
    test::Random random(8);
    for (int i = 0; i < 3000; ++i) {
        SampleFrame f = golden_sample();
        f.header.sequence = static_cast<std::uint32_t>(random.bits());
        f.header.session = static_cast<std::uint32_t>(random.bits() % 3);
        f.header.queued_ns = random.bits() >> (random.bits() % 40);
        f.exposure_ns = f.header.queued_ns / 2;
        f.camera_frame = static_cast<std::uint32_t>(random.bits());
        tracker.transport.push(at_ms(i), f.encode());
    }
    while (sample_of(source)) {
    }
    EXPECT_EQ(source.counts().samples + source.counts().rejected, 3000u);
    EXPECT_GT(source.counts().samples, 500u);
}

}  // namespace
}  // namespace foverig::gaze
