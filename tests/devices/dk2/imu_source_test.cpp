#include "devices/dk2/imu_source.h"

#include <gtest/gtest.h>

#include "devices/display/panel_timing.h"
#include "devices/dk2/feature_reports.h"
#include "tests/devices/byte_text.h"
#include "tests/devices/fake_transport.h"

namespace foverig::dk2 {
namespace {

using test::copy_of;
using test::FakeTransport;

constexpr Nanoseconds kMs{1'000'000};

HostTime at_ms(double ms) {
    return HostTime(from_seconds(ms * 1e-3));
}

void script_answers(FakeTransport& t) {
    t.answers[FactoryCalibrationReport::kId] = copy_of(FactoryCalibrationReport{}.encode());
    t.answers[ConfigReport::kId] = copy_of(ConfigReport{}.encode());
    t.answers[DisplayReport::kId] = copy_of(DisplayReport{}.encode());
}

Dk2ImuSource open(FakeTransport& t) {
    script_answers(t);
    auto source = Dk2ImuSource::open(t, HostTime{});
    EXPECT_TRUE(source) << (source ? "" : source.error().text);
    return std::move(source).value();
}

InputReport11 report(std::uint16_t count, std::uint32_t stamp_us) {
    InputReport11 r;
    r.sample_count = count;
    r.sample_timestamp_us = stamp_us;
    return r;
}

TEST(Dk2ImuSource, TakesTheCalibrationOverAndTurnsTheLatencyTesterOn) {
    FakeTransport t;
    open(t);
    ASSERT_EQ(t.sets.size(), 4u);
    const auto config = ConfigReport::decode(t.sets[0].data);
    ASSERT_TRUE(config);
    EXPECT_FALSE(config->use_calibration);
    EXPECT_TRUE(config->auto_calibration);
    EXPECT_EQ(config->interval, 0);
    const auto range = RangeReport::decode(t.sets[1].data);
    ASSERT_TRUE(range);
    EXPECT_EQ(range->gyro_deg_s, 2000);
    const auto display = DisplayReport::decode(t.sets[2].data);
    ASSERT_TRUE(display);
    EXPECT_TRUE(display->read_pixel);
    EXPECT_EQ(display->persistence_rows, 435);
    const auto awake = KeepAliveMuxReport::decode(t.sets[3].data);
    ASSERT_TRUE(awake);
    EXPECT_EQ(awake->input_report, 11);
    EXPECT_EQ(awake->timeout_ms, 10000);
    EXPECT_EQ(awake->command_id, 4);
}

TEST(Dk2ImuSource, LightsThePanelAsItsTimingTakesIt) {
    FakeTransport t;
    script_answers(t);
    t.answers[DisplayReport::kId] =
        copy_of(DisplayReport{.use_rolling = false, .persistence_rows = 348}.encode());
    ASSERT_TRUE(Dk2ImuSource::open(t, HostTime{}));
    const auto display = DisplayReport::decode(t.sets[2].data);
    ASSERT_TRUE(display);
    EXPECT_EQ(display->persistence_rows, PanelTiming{}.persistence_rows);
    EXPECT_TRUE(display->use_rolling);
}

TEST(Dk2ImuSource, OpenSaysWhichReportFailed) {
    FakeTransport t;
    script_answers(t);
    t.answers[ConfigReport::kId] = {};
    EXPECT_FALSE(Dk2ImuSource::open(t, HostTime{}));
    t.answers.erase(FactoryCalibrationReport::kId);
    const auto source = Dk2ImuSource::open(t, HostTime{});
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error().code, ErrorCode::unsupported);
}

TEST(Dk2ImuSource, GivesHostTimesFreeOfPollingJitterAcrossTheWrap) {
    FakeTransport t;
    Dk2ImuSource source = open(t);
    test::Random random(9);
    // The device's clock starts 5 s before its wrap and gains 20 ppm.
    const double start_us = 4294967296.0 - 5e6;
    for (int i = 0; i < 10000; ++i) {
        const double device_us = start_us + i * 1000 * (1 + 20e-6);
        const auto stamp = static_cast<std::uint32_t>(static_cast<std::int64_t>(device_us));
        t.push(at_ms(i + random.uniform()),
               report(static_cast<std::uint16_t>(60000 + i), stamp).encode());
    }
    double worst_ms = 0;
    HostTime before{};
    for (int i = 0; i < 10000; ++i) {
        const auto next = source.next(at_ms(20000));
        const auto* sample = std::get_if<ImuSample>(&next);
        ASSERT_NE(sample, nullptr);
        if (i > 0) {
            ASSERT_GE(sample->host_time, before);
        }
        before = sample->host_time;
        if (i > 1000) worst_ms = std::max(worst_ms, std::abs(to_ms(sample->host_time - at_ms(i))));
    }
    EXPECT_LT(worst_ms, 0.1);
    EXPECT_EQ(source.counts().samples, 10000u);
    EXPECT_EQ(source.counts().lost, 0u);
    EXPECT_EQ(source.counts().rejected, 0u);
    EXPECT_EQ(source.clock_map().resets(), 0u);
}

/// Whoever reads the device keeps it awake: how often the source is asked says nothing.
TEST(Dk2ImuSource, HasTheDeviceKeptAwakeEachThreeSecondsAndSendsNothingItself) {
    FakeTransport t;
    Dk2ImuSource source = open(t);
    ASSERT_EQ(t.keep_awakes.size(), 1u);
    EXPECT_EQ(t.keep_awakes[0].id, KeepAliveMuxReport::kId);
    EXPECT_EQ(t.keep_awakes[0].period, 3000 * kMs);
    EXPECT_EQ(t.keep_awakes[0].data, t.sets.back().data);
    t.sets.clear();
    for (int i = 0; i < 10000; ++i)
        t.push(at_ms(i), report(static_cast<std::uint16_t>(i), 1000u * (i + 1u)).encode());
    for (int i = 0; i < 10000; ++i) (void)source.next(at_ms(10000));
    EXPECT_TRUE(std::holds_alternative<Timeout>(source.next(at_ms(30000))));
    EXPECT_EQ(t.sets.size(), 0u);
    EXPECT_EQ(t.deadlines.back(), at_ms(30000));
}

TEST(Dk2ImuSource, AnswersReport1WithKeepAliveMuxAndGoesOn) {
    FakeTransport t;
    Dk2ImuSource source = open(t);
    t.sets.clear();
    t.push(at_ms(1), report(1, 1000).encode());
    for (std::uint16_t i = 2; i < 6; ++i) {
        InputReport1 old;
        old.sample_count = i;
        t.push(at_ms(i), old.encode());
    }
    t.push(at_ms(6), report(6, 6000).encode());
    for (int i = 1; i <= 6; ++i) {
        const auto next = source.next(at_ms(10));
        const auto* sample = std::get_if<ImuSample>(&next);
        ASSERT_NE(sample, nullptr);
        EXPECT_EQ(sample->device_time, Dk2Time(i * kMs));
        EXPECT_EQ(sample->host_time, at_ms(i));
    }
    EXPECT_EQ(source.format_switches(), 1u);  // reports in flight do not ask again
    EXPECT_EQ(t.sets_of(KeepAliveMuxReport::kId), 1);
}

TEST(Dk2ImuSource, CountsLossAndRejectsWithoutStopping) {
    FakeTransport t;
    Dk2ImuSource source = open(t);
    t.push(at_ms(1), report(1, 1000).encode());
    t.push(at_ms(2), std::vector<std::byte>(17));
    t.push(at_ms(2), std::vector<std::byte>{});
    t.push(at_ms(5), report(5, 5000).encode());
    t.push(at_ms(5), report(1, 1000).encode());
    for (int i = 0; i < 2; ++i)
        ASSERT_TRUE(std::holds_alternative<ImuSample>(source.next(at_ms(10))));
    EXPECT_TRUE(std::holds_alternative<Timeout>(source.next(at_ms(10))));
    EXPECT_EQ(source.counts().lost, 3u);
    EXPECT_EQ(source.counts().rejected, 3u);
}

TEST(Dk2ImuSource, GivesEachFramesReadbackOnceInHostTime) {
    FakeTransport t;
    Dk2ImuSource source = open(t);
    for (int i = 0; i < 30; ++i) {
        InputReport11 r = report(static_cast<std::uint16_t>(i), 1000u * (i + 1u));
        r.frame_count = static_cast<std::uint16_t>(65535 + i / 13);
        r.frame_timestamp_us = 1000u * (i / 13 * 13 + 1u);
        r.frame_id = static_cast<std::uint8_t>(48 + 32 * (i / 13));
        t.push(at_ms(i + 1), r.encode());
    }
    for (int i = 0; i < 30; ++i) (void)source.next(at_ms(100));
    const auto readbacks = source.take_panel_readbacks();
    ASSERT_EQ(readbacks.size(), 3u);
    EXPECT_EQ(readbacks[1].frame_count, 0);
    EXPECT_EQ(readbacks[1].vsync, at_ms(14));
    EXPECT_EQ(readbacks[2].grey, 112);
    EXPECT_TRUE(source.take_panel_readbacks().empty());
}

TEST(Dk2ImuSource, PassesFaultAndEndOn) {
    FakeTransport t;
    Dk2ImuSource source = open(t);
    t.fault_at_end = Error{ErrorCode::closed, "unplugged"};
    const auto next = source.next(at_ms(1));
    ASSERT_TRUE(std::holds_alternative<Fault>(next));
    EXPECT_EQ(std::get<Fault>(next).error.code, ErrorCode::closed);
    t.fault_at_end.reset();
    t.end_at_end = true;
    EXPECT_TRUE(std::holds_alternative<EndOfStream>(source.next(at_ms(1))));
}

TEST(Dk2ImuSource, AHeadsetThatWasGoneBeginsAnewWhateverItsClockSays) {
    // A clock that began anew looks like one that ran on where it was above 2^31 us; one that ran
    // on, and one that stopped at the same stamp, are links that were opened again.
    for (const std::uint32_t later_us : {2'000'000U, 3'000'500'000U, 3'000'000'000U}) {
        FakeTransport t;
        Dk2ImuSource source = open(t);
        t.push(at_ms(1), report(7, 3'000'000'000U).encode());
        EXPECT_TRUE(std::holds_alternative<ImuSample>(source.next(at_ms(2))));
        t.fault_at_end = Error{ErrorCode::closed, "unplugged"};
        EXPECT_TRUE(std::holds_alternative<Fault>(source.next(at_ms(3))));
        t.fault_at_end.reset();
        for (std::uint32_t i = 0; i < 20; ++i) {
            t.push(at_ms(900 + i),
                   report(static_cast<std::uint16_t>(40'000 + i), later_us + 1000 * i).encode());
            const auto next = source.next(at_ms(1000));
            const auto* const sample = std::get_if<ImuSample>(&next);
            ASSERT_NE(sample, nullptr) << later_us << ", report " << i;
            EXPECT_EQ(sample->gap, i == 0);
        }
        EXPECT_EQ(t.keep_awakes.size(), 2U) << "who comes back is to be kept awake, too";
        EXPECT_EQ(source.counts().reconnects, 1U) << later_us;
        EXPECT_EQ(source.counts().lost, 0U) << later_us;
        EXPECT_EQ(source.counts().rejected, 0U) << later_us;
    }
}

TEST(Dk2ImuSource, ARefusedCorrectionIsCountedNotFatal) {
    FakeTransport t;
    Dk2ImuSource source = open(t);
    t.refuse_sets = true;
    t.push(at_ms(1), report(1, 1000).encode());
    t.push(at_ms(2), InputReport1{.sample_count = 2}.encode());
    EXPECT_TRUE(std::holds_alternative<ImuSample>(source.next(at_ms(10))));
    EXPECT_TRUE(std::holds_alternative<ImuSample>(source.next(at_ms(10))));
    EXPECT_EQ(source.failed_requests().refused, 1u);
}

/// What a transport that leaves a silent headset alone says is no failure of the headset's.
TEST(Dk2ImuSource, ARequestThatWasNotSentIsCountedApart) {
    FakeTransport t;
    Dk2ImuSource source = open(t);
    t.refuse_sets = true;
    for (int i = 0; i < 3; ++i) {
        t.fault_at_end = Error{ErrorCode::closed, "unplugged"};
        EXPECT_TRUE(std::holds_alternative<Fault>(source.next(at_ms(1000 * i))));
        t.fault_at_end.reset();
        t.refusal = i == 0 ? ErrorCode::io : ErrorCode::not_asked;
        t.push(at_ms(1000 * i + 1), report(1, 1000 * (i + 1)).encode());
        (void)source.next(at_ms(1000 * i + 2));
    }
    EXPECT_EQ(source.failed_requests().refused, 1u);
    EXPECT_EQ(source.failed_requests().not_sent, 2u);
}

}  // namespace
}  // namespace foverig::dk2
