// What each fault of faults.dk2 does to the bytes.
#include <gtest/gtest.h>

#include <cmath>

#include "devices/dk2/feature_reports.h"
#include "tests/simulators/dk2/dk2_bench.h"

namespace foverig {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using test::at;
using test::Dk2Bench;
using test::InputReport11;
using test::with;

TEST(SimulatedDk2, CountsLossesLikeTheDocumentedTest) {
    Dk2Bench dk2(with("dropout", 0.1));
    const auto reports = dk2.reports_until(at(seconds(9)));
    std::size_t lost = 0;
    for (std::size_t i = 1; i < reports.size(); ++i) {
        const auto& before = reports[i - 1].report;
        lost += static_cast<std::uint16_t>(reports[i].report.sample_count -
                                           (before.sample_count + before.num_samples));
    }
    const std::size_t first = reports.front().report.sample_count;
    const std::size_t last = reports.back().report.sample_count;
    EXPECT_EQ(reports.size() + lost, last - first + 1);
    EXPECT_NEAR(static_cast<double>(lost) / 9000.0, 0.1, 4.0 * std::sqrt(0.1 * 0.9 / 9000.0));
}

TEST(SimulatedDk2, LosesInBurstsWhenAsked) {
    auto settings = with("dropout", 0.1);
    settings.faults.dropout_burst = 8.0;
    Dk2Bench dk2(settings);
    const auto reports = dk2.reports_until(at(milliseconds(9900)));
    int gaps = 0, lost = 0;
    for (std::size_t i = 1; i < reports.size(); ++i) {
        const int step = static_cast<std::uint16_t>(reports[i].report.sample_count -
                                                    reports[i - 1].report.sample_count);
        gaps += step > 1 ? 1 : 0;
        lost += step - 1;
    }
    EXPECT_NEAR(lost / 9900.0, 0.1, 0.03);
    EXPECT_NEAR(static_cast<double>(lost) / gaps, 8.0, 2.0);
}

TEST(SimulatedDk2, SampleCountAndStampWrap) {
    Dk2Bench dk2(with("wrap", 3.0));
    ASSERT_TRUE(dk2.set(dk2::KeepAliveMuxReport{.timeout_ms = 65535}));
    ASSERT_TRUE(dk2.set(dk2::ConfigReport{.command_keep_alive = false, .interval = 9}));
    const auto reports = dk2.reports_until(at(seconds(70)));
    int count_wraps = 0, stamp_wraps = 0;
    for (std::size_t i = 1; i < reports.size(); ++i) {
        const auto &a = reports[i - 1].report, &b = reports[i].report;
        EXPECT_EQ(static_cast<std::uint16_t>(b.sample_count - a.sample_count), 10);
        EXPECT_EQ(b.sample_timestamp_us - a.sample_timestamp_us, 10000u);
        count_wraps += b.sample_count < a.sample_count ? 1 : 0;
        stamp_wraps += b.sample_timestamp_us < a.sample_timestamp_us ? 1 : 0;
    }
    EXPECT_EQ(count_wraps, 1);  // 65.536 s
    EXPECT_EQ(stamp_wraps, 1);  // 3 s
}

TEST(SimulatedDk2, ClockDriftChangesOnlyTheStamps) {
    Dk2Bench plain, drifting(with("clock_drift", 100.0));
    const auto a = plain.reports_until(at(seconds(8))), b = drifting.reports_until(at(seconds(8)));
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].at, b[i].at);
        InputReport11 same = b[i].report;
        same.sample_timestamp_us = a[i].report.sample_timestamp_us;
        EXPECT_EQ(same, a[i].report);
    }
    EXPECT_NEAR(b.back().report.sample_timestamp_us - a.back().report.sample_timestamp_us, 800.0,
                1.0);
}

TEST(SimulatedDk2, EachValueFaultLeavesTheScheduleAlone) {
    for (const char* kind :
         {"noise", "bias", "scale", "random_walk", "quantise", "low_pass", "temperature_drift"}) {
        Dk2Bench plain, faulty(with(kind, 1.0));
        const auto a = plain.reports_until(at(milliseconds(300)));
        const auto b = faulty.reports_until(at(milliseconds(300)));
        ASSERT_EQ(a.size(), b.size()) << kind;
        bool differs = false;
        for (std::size_t i = 0; i < a.size(); ++i) {
            ASSERT_EQ(a[i].at, b[i].at) << kind;
            ASSERT_EQ(a[i].report.sample_timestamp_us, b[i].report.sample_timestamp_us) << kind;
            differs |= !(a[i].report.slots == b[i].report.slots);
        }
        EXPECT_TRUE(differs) << kind;
    }
}

TEST(SimulatedDk2, HostDelayIsOneSidedAndKeepsTheOrder) {
    Dk2Bench dk2(with("host_delay", 0.5));
    const auto reports = dk2.reports_until(at(seconds(5)));
    double sum_ms = 0;
    for (std::size_t i = 0; i < reports.size(); ++i) {
        const HostTime polled = at((i + 1) * milliseconds(1) + Nanoseconds(100'000));
        ASSERT_GE(reports[i].at, polled);
        ASSERT_EQ(reports[i].report.sample_count, i);
        sum_ms += to_ms(reports[i].at - polled);
    }
    // Waiting for the one before adds to the mean delay of 0.5 ms.
    EXPECT_GT(sum_ms / static_cast<double>(reports.size()), 0.5);
    EXPECT_LT(sum_ms / static_cast<double>(reports.size()), 0.8);
}

TEST(SimulatedDk2, RateErrorSlidesTheSamplesThroughThePollGrid) {
    Dk2Bench dk2(with("rate_error", 3000.0));  // 1003 us a sample
    const auto reports = dk2.reports_until(at(seconds(5)));
    Nanoseconds shortest = seconds(1), longest{0};
    for (std::size_t i = 0; i < reports.size(); ++i) {
        const HostTime sampled = at(Nanoseconds(1'003'000) * static_cast<std::int64_t>(i + 1));
        shortest = std::min(shortest, reports[i].at - sampled);
        longest = std::max(longest, reports[i].at - sampled);
    }
    EXPECT_LT(shortest, Nanoseconds(10'000));
    EXPECT_GT(longest, Nanoseconds(990'000));
    EXPECT_LE(longest, Nanoseconds(1'000'000));
}

TEST(SimulatedDk2, FastSamplesShareAReportNowAndThen) {
    Dk2Bench dk2(with("rate_error", -10000.0));  // 990 us a sample: 10 more a second than polls
    const auto reports = dk2.reports_until(at(seconds(2)));
    int doubles = 0, next = 0;
    for (const auto& [arrival, report] : reports) {
        EXPECT_EQ(report.sample_count, next);
        next += report.num_samples;
        doubles += report.num_samples == 2 ? 1 : 0;
    }
    EXPECT_NEAR(doubles, 20, 2);
}

TEST(SimulatedDk2, UnpluggedIsAFaultAndThenANewDevice) {
    auto settings = with("unplug_at", 1.0);
    settings.faults.unplug_for = 0.5;
    Dk2Bench dk2(settings);
    const auto before = dk2.reports_until(at(milliseconds(1200)));
    EXPECT_LE(before.back().at, at(seconds(1)));
    dk2.clock.sleep_until(at(milliseconds(1200)));
    const auto next = dk2.device.next(at(milliseconds(1200)));
    ASSERT_TRUE(std::holds_alternative<Fault>(next));
    EXPECT_EQ(std::get<Fault>(next).error.code, ErrorCode::closed);
    EXPECT_EQ(dk2.device.control_get(2, 0, 7).error().code, ErrorCode::closed);
    dk2.clock.sleep_until(at(milliseconds(1500)));
    const auto after = dk2.reports_until(at(milliseconds(1600)));
    ASSERT_FALSE(after.empty());
    EXPECT_EQ(after.front().report.sample_count, 0);
    EXPECT_EQ(after.front().report.sample_timestamp_us, 2'001'000u);
}

TEST(SimulatedDk2, BackwardsStampsComeAtTheirRate) {
    Dk2Bench dk2(with("backwards_stamp", 0.05));
    const auto reports = dk2.reports_until(at(seconds(5)));
    int backwards = 0;
    for (std::size_t i = 1; i < reports.size(); ++i) {
        const auto step = static_cast<std::int32_t>(reports[i].report.sample_timestamp_us -
                                                    reports[i - 1].report.sample_timestamp_us);
        backwards += step < 0 ? 1 : 0;
    }
    EXPECT_NEAR(backwards, 0.05 * 5000 * 0.95, 45);  // two in a row count once
}

}  // namespace
}  // namespace foverig
