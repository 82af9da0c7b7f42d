#include "simulators/dk2/simulated_dk2.h"

#include <gtest/gtest.h>

#include <vector>

#include "devices/dk2/feature_reports.h"
#include "simulators/motion/look_head.h"
#include "simulators/motion/simple_heads.h"

namespace foverig {
namespace {

using dk2::InputReport11;
using std::chrono::milliseconds;
using std::chrono::seconds;

struct Arrived {
    HostTime at;
    InputReport11 report;
};

class Dk2 {
  public:
    explicit Dk2(const SimulatedDk2::Settings& settings = {}) : device(clock, look, settings) {}

    /// Everything that arrives until then.
    std::vector<Packet> packets_until(HostTime until) {
        std::vector<Packet> packets;
        while (true) {
            auto next = device.next(until);
            auto* packet = std::get_if<Packet>(&next);
            if (packet == nullptr) return packets;
            packets.push_back(std::move(*packet));
        }
    }
    std::vector<Arrived> reports_until(HostTime until) {
        std::vector<Arrived> reports;
        for (const Packet& packet : packets_until(until)) {
            const auto report = InputReport11::decode(packet.bytes);
            EXPECT_TRUE(report);
            reports.push_back({packet.arrival, *report});
        }
        return reports;
    }
    template <class Report>
    Status set(const Report& report) {
        return device.control_set(Report::kId, 0, report.encode());
    }
    template <class Report>
    Report get() {
        const auto bytes = device.control_get(Report::kId, 0, Report::kSize);
        EXPECT_TRUE(bytes);
        return *Report::decode(*bytes);
    }

    ManualClock clock;
    motion::LookHead look{4};
    SimulatedDk2 device;
};

HostTime at(Nanoseconds t) {
    return HostTime(t);
}

SimulatedDk2::Settings with(const char* kind, double value, std::uint64_t seed = 0) {
    FaultSettings faults;
    EXPECT_TRUE(set_fault(faults, "dk2", kind, value));
    return {.faults = faults.dk2, .seed = seed};
}

TEST(SimulatedDk2, StreamsTheTruthOnScheduleWithoutFaults) {
    Dk2 dk2;
    const auto reports = dk2.reports_until(at(seconds(2)));
    ASSERT_EQ(reports.size(),
              1999u);  // the sample of 2.000 s is polled a tenth of a millisecond later
    for (std::size_t i = 0; i < reports.size(); ++i) {
        const auto& [arrival, report] = reports[i];
        const Nanoseconds sampled = (i + 1) * milliseconds(1);
        ASSERT_EQ(arrival, at(sampled + Nanoseconds(100'000)));
        ASSERT_EQ(report.num_samples, 1);
        ASSERT_EQ(report.sample_count, i);
        ASSERT_EQ(report.sample_timestamp_us, 2'000'000u + 1000u * (i + 1));
        ASSERT_EQ(report.temperature_centi_c, 2500);
        const motion::HeadState truth = dk2.look.at(to_seconds(sampled));
        ASSERT_LE(glm::distance(dk2::to_si(report.slots[0].gyro), truth.angular_velocity_rad_s),
                  0.87e-4);
        ASSERT_EQ(report.slots[1], dk2::InertialSlot{});
    }
}

TEST(SimulatedDk2, PacksByTheConfiguredInterval) {
    for (const int interval : {0, 1, 2, 9}) {
        Dk2 dk2;
        ASSERT_TRUE(dk2.set(dk2::ConfigReport{.interval = static_cast<std::uint8_t>(interval)}));
        const auto reports = dk2.reports_until(at(milliseconds(1800) + milliseconds(1)));
        ASSERT_EQ(reports.size(), 1800u / (interval + 1)) << interval;
        for (std::size_t i = 0; i < reports.size(); ++i) {
            EXPECT_EQ(reports[i].report.num_samples, interval + 1);
            EXPECT_EQ(reports[i].report.sample_count, i * (interval + 1));
        }
    }
}

TEST(SimulatedDk2, AnswersWhatWasSetAndEchoesTheCommand) {
    Dk2 dk2;
    EXPECT_EQ(dk2.get<dk2::ConfigReport>(), dk2::ConfigReport{});  // power-on 0x2C
    dk2::ConfigReport config{.command_id = 77, .interval = 1};
    ASSERT_TRUE(dk2.set(config));
    EXPECT_EQ(dk2.get<dk2::ConfigReport>(), config);
    EXPECT_EQ(dk2.reports_until(at(milliseconds(4))).back().report.last_command_id, 77);
    // Read-only fields stay.
    ASSERT_TRUE(
        dk2.set(dk2::DisplayReport{.read_pixel = true, .pixel_settle_us = 9, .total_rows = 9}));
    EXPECT_EQ(dk2.get<dk2::DisplayReport>().total_rows, 1933);
    EXPECT_EQ(dk2.get<dk2::DisplayReport>().pixel_settle_us, 100);
    EXPECT_TRUE(dk2.get<dk2::DisplayReport>().read_pixel);
    EXPECT_EQ(dk2.get<dk2::SerialReport>().serial.size(), 12u);
}

TEST(SimulatedDk2, RefusesWhatItDoesNotKnow) {
    Dk2 dk2;
    const std::array<std::byte, 4> dfu{std::byte{6}};
    EXPECT_EQ(dk2.device.control_set(6, 0, dfu).error().code, ErrorCode::unsupported);
    EXPECT_EQ(dk2.device.control_set(2, 0, dfu).error().code, ErrorCode::invalid_data);
    EXPECT_EQ(dk2.device.control_set(2, 0, {}).error().code, ErrorCode::invalid_data);
    EXPECT_EQ(dk2.device.control_get(99, 0, 64).error().code, ErrorCode::unsupported);
}

TEST(SimulatedDk2, FallsSilentWhenTheKeepAliveRunsOutAndRevives) {
    Dk2 dk2;
    // Power-on: 10 s after the last SET of any report; none was sent.
    const auto reports = dk2.reports_until(at(seconds(15)));
    ASSERT_FALSE(reports.empty());
    EXPECT_LT(reports.back().at, at(milliseconds(10002)));
    EXPECT_GT(reports.back().at, at(milliseconds(9998)));
    ASSERT_TRUE(dk2.set(dk2::KeepAliveMuxReport{.timeout_ms = 500}));
    const auto revived = dk2.reports_until(at(seconds(20)));
    ASSERT_FALSE(revived.empty());
    EXPECT_LT(revived.front().at, at(milliseconds(15003)));
    EXPECT_NEAR(to_seconds(revived.back().at.time_since_epoch()), 15.5, 0.003);
    // The count went on while the device was silent: the host sees the loss.
    const auto& last = reports.back().report;
    const auto lost = static_cast<std::uint16_t>(revived.front().report.sample_count -
                                                 (last.sample_count + last.num_samples));
    EXPECT_GT(lost, 4500);
}

TEST(SimulatedDk2, StaysAwakeWithoutCommandKeepAlive) {
    Dk2 dk2;
    ASSERT_TRUE(dk2.set(dk2::ConfigReport{.command_keep_alive = false}));
    EXPECT_EQ(dk2.reports_until(at(seconds(12))).size(), 11999u);
}

TEST(SimulatedDk2, SwitchesToTheOldReportOnReportEight) {
    Dk2 dk2;
    ASSERT_TRUE(dk2.set(dk2::Dk1KeepAliveReport{}));
    auto packets = dk2.packets_until(at(milliseconds(5)));
    ASSERT_FALSE(packets.empty());
    EXPECT_EQ(packets.back().bytes.size(), 62u);
    ASSERT_TRUE(dk2::InputReport1::decode(packets.back().bytes));
    ASSERT_TRUE(dk2.set(dk2::KeepAliveMuxReport{}));
    packets = dk2.packets_until(at(milliseconds(10)));
    EXPECT_EQ(packets.back().bytes.size(), 64u);
}

TEST(SimulatedDk2, CountsLossesLikeTheDocumentedTest) {
    Dk2 dk2(with("dropout", 0.1));
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
    Dk2 dk2(settings);
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
    Dk2 dk2(with("wrap", 3.0));
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
    Dk2 plain, drifting(with("clock_drift", 100.0));
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
        Dk2 plain, faulty(with(kind, 1.0));
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
    Dk2 dk2(with("host_delay", 0.5));
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
    Dk2 dk2(with("rate_error", 3000.0));  // 1003 us a sample
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
    Dk2 dk2(with("rate_error", -10000.0));  // 990 us a sample: 10 more a second than polls
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
    Dk2 dk2(settings);
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
    Dk2 dk2(with("backwards_stamp", 0.05));
    const auto reports = dk2.reports_until(at(seconds(5)));
    int backwards = 0;
    for (std::size_t i = 1; i < reports.size(); ++i) {
        const auto step = static_cast<std::int32_t>(reports[i].report.sample_timestamp_us -
                                                    reports[i - 1].report.sample_timestamp_us);
        backwards += step < 0 ? 1 : 0;
    }
    EXPECT_NEAR(backwards, 0.05 * 5000 * 0.95, 45);  // two in a row count once
}

TEST(SimulatedDk2, LedsExposeAtTheirInterval) {
    Dk2 dk2;
    ASSERT_TRUE(dk2.set(dk2::TrackingReport{.enable = true, .frame_interval_us = 16666}));
    const auto reports = dk2.reports_until(at(seconds(1)));
    EXPECT_EQ(reports.back().report.tracking_count, 59);  // at 983.3 ms
    EXPECT_EQ(reports.back().report.tracking_timestamp_us, 2'000'000u + 59u * 16666u);
    EXPECT_EQ(reports.back().report.tracking_pattern, 58 % 10);
}

TEST(SimulatedDk2, SameSeedGivesTheSameBytes) {
    auto settings = with("noise", 1.0, 9);
    settings.faults.host_delay = 0.2;
    settings.faults.dropout = 0.02;
    settings.faults.jitter = 2.0;
    Dk2 a(settings), b(settings);
    settings.seed = 10;
    Dk2 c(settings);
    const auto pa = a.packets_until(at(seconds(1)));
    // The second is asked in small steps, which must not matter.
    std::vector<Packet> pb;
    for (int ms = 3; ms <= 1000; ms += 3) {
        for (auto& p : b.packets_until(at(milliseconds(std::min(ms, 999))))) pb.push_back(p);
    }
    for (auto& p : b.packets_until(at(seconds(1)))) pb.push_back(p);
    ASSERT_EQ(pa.size(), pb.size());
    for (std::size_t i = 0; i < pa.size(); ++i) {
        ASSERT_EQ(pa[i].arrival, pb[i].arrival);
        ASSERT_EQ(pa[i].bytes, pb[i].bytes);
    }
    EXPECT_NE(pa[5].bytes, c.packets_until(at(seconds(1)))[5].bytes);
}

TEST(SimulatedDk2, NeverReachesBeyondTheDeadline) {
    Dk2 dk2;
    ASSERT_TRUE(std::holds_alternative<Timeout>(dk2.device.next(at(Nanoseconds(1'050'000)))));
    EXPECT_EQ(dk2.clock.now(), at(Nanoseconds(1'050'000)));
    // A deadline in the past neither moves the clock nor gives what came after it.
    dk2.clock.sleep_until(at(milliseconds(10)));
    const auto past = dk2.device.next(at(milliseconds(2)));
    ASSERT_TRUE(std::holds_alternative<Packet>(past));
    EXPECT_TRUE(std::holds_alternative<Timeout>(dk2.device.next(at(milliseconds(2)))));
    EXPECT_EQ(dk2.clock.now(), at(milliseconds(10)));
}

TEST(SimulatedDk2, RunsOnAWallClockToo) {
    WallClock clock;
    const motion::StillHead still;
    SimulatedDk2 device(clock, still);
    const HostTime until = clock.now() + milliseconds(20);
    int packets = 0;
    while (std::holds_alternative<Packet>(device.next(until))) ++packets;
    EXPECT_GE(clock.now(), until);
    EXPECT_GE(packets, 19);  // however late the machine is, none is skipped
}

}  // namespace
}  // namespace foverig
