#include "simulators/dk2/simulated_dk2.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "devices/dk2/about.h"
#include "devices/dk2/calibration_reports.h"
#include "devices/dk2/imu_source.h"
#include "simulators/motion/simple_heads.h"
#include "tests/simulators/dk2/dk2_bench.h"

namespace foverig {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using test::at;
using test::Dk2Bench;
using test::with;

TEST(SimulatedDk2, StreamsTheTruthOnScheduleWithoutFaults) {
    Dk2Bench dk2;
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
        Dk2Bench dk2;
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
    Dk2Bench dk2;
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

// The sizes that the device answers with (DEVICES.md 1.1); 1 and 11 are input reports, 7 is not
// supported, 6 leads to the boot loader.
TEST(SimulatedDk2, AnswersEveryFeatureReportAndStallsOnTheOthers) {
    const std::map<int, std::size_t> sizes{
        {2, 7},   {3, 69},  {4, 8},   {5, 6},  {8, 5},   {9, 56},  {10, 15}, {12, 13}, {13, 16},
        {14, 52}, {15, 30}, {16, 12}, {17, 6}, {18, 16}, {19, 23}, {20, 24}, {21, 18}, {22, 64}};
    Dk2Bench dk2;
    ASSERT_TRUE(dk2.set(dk2::KeepAliveMuxReport{.command_id = 0x1234}));
    for (int id = 0; id < 256; ++id) {
        const auto answer = dk2.device.control_get(static_cast<std::uint8_t>(id), 0, 255);
        const auto size = sizes.find(id);
        ASSERT_EQ(static_cast<bool>(answer), size != sizes.end()) << id;
        if (!answer) continue;
        EXPECT_EQ(answer->size(), size->second) << id;
        EXPECT_EQ(read_u8(*answer, 0), id);
        EXPECT_EQ(read_u16(*answer, 1), 0x1234) << id;
    }
}

TEST(SimulatedDk2, WalksThroughItsTemperatureTableAndItsStages) {
    Dk2Bench dk2;
    for (int round = 0; round < 2; ++round) {
        for (int cell = 0; cell < 35; ++cell) {
            const auto report = dk2.get<dk2::TemperatureReport>();
            EXPECT_EQ(report.bin, cell / 5);
            EXPECT_EQ(report.sample, cell % 5);
            EXPECT_EQ(report.target_centi_c, 1500 + 500 * (cell / 5));
            EXPECT_EQ(report.version, 0);
        }
        for (int stage = 0; stage < 10; ++stage) {
            EXPECT_EQ(dk2.get<dk2::ManufacturingReport>().stage, stage);
        }
    }
}

// At rest the gyro says its bias alone, and the table says the same at that temperature.
TEST(SimulatedDk2, HasStoredItsBiasByTemperatureWhereAsked) {
    SimulatedDk2::Settings settings = with("temperature_table", 1.0, 3);
    settings.faults.bias = 0.5;
    settings.faults.temperature_drift = 0.05;
    ManualClock clock;
    const motion::StillHead still;
    SimulatedDk2 device(clock, still, settings);
    auto source = std::move(dk2::Dk2ImuSource::open(device, clock.now())).value();
    const auto& offsets = source.calibration().gyro_offsets;
    ASSERT_EQ(offsets.stored().size(), 7U);
    ASSERT_TRUE(offsets.by_temperature());
    for (int i = 0; i < 5000; ++i) {
        const auto next = source.next(at(seconds(600)));
        const auto* sample = std::get_if<ImuSample>(&next);
        ASSERT_NE(sample, nullptr);
        EXPECT_GT(glm::length(offsets.at(sample->temperature_c)), glm::radians(0.1));
        // Half a unit of the sample's and of the table's, on three axes.
        ASSERT_LE(glm::length(sample->gyro_rad_s), 1e-4 * std::sqrt(3.0));
    }
}

TEST(SimulatedDk2, SaysThatItWasNeverMade) {
    Dk2Bench dk2;
    ASSERT_TRUE(dk2.set(dk2::RegisterReport{
        .chip = dk2::RegisterReport::Chip::lis3mdl, .address = 0x20, .payload = 0x70}));
    const auto about = dk2::read_about(dk2.device);
    ASSERT_TRUE(about) << about.error().text;
    EXPECT_EQ(about->serial, about->uuid.substr(0, 12));
    EXPECT_EQ(about->uuid.size(), 20U);
    EXPECT_TRUE(about->stages.empty());
    EXPECT_EQ(about->written.payload, 0x70);
}

TEST(SimulatedDk2, TakesTheNextRangeUp) {
    Dk2Bench dk2;
    ASSERT_TRUE(
        dk2.set(dk2::RangeReport{.accel_g = 3, .gyro_deg_s = 251, .mag_milligauss = 60000}));
    EXPECT_EQ(dk2.get<dk2::RangeReport>(),
              (dk2::RangeReport{.accel_g = 4, .gyro_deg_s = 500, .mag_milligauss = 16000}));
}

/// A turn of 60 degrees in 0.25 s comes to 450 deg/s (minimum jerk: 1.875 times the mean), which a
/// range of 250 clips, until a source sets the headset up.
TEST(SimulatedDk2, ClipsAtTheRangeThatAnotherProgramLeft) {
    for (const bool set_up : {false, true}) {
        ManualClock clock;
        const motion::StepHead head({.amplitude_deg = 60.0, .duration_s = 0.25});
        SimulatedDk2 device(clock, head, with("quantise", 1.0));
        ASSERT_TRUE(device.control_set(4, 0, dk2::RangeReport{.gyro_deg_s = 250}.encode()));
        if (set_up) {
            ASSERT_TRUE(dk2::Dk2ImuSource::open(device, clock.now()));
        }
        double fastest_deg_s = 0.0;
        while (true) {
            const auto next = device.next(at(seconds(2)));
            const auto* packet = std::get_if<Packet>(&next);
            if (packet == nullptr) break;
            const auto report = dk2::InputReport11::decode(packet->bytes);
            fastest_deg_s =
                std::max(fastest_deg_s, glm::degrees(dk2::to_si(report->slots[0].gyro).y));
        }
        EXPECT_NEAR(fastest_deg_s, set_up ? 450.0 : 250.0, 0.1);
    }
}

TEST(SimulatedDk2, RefusesWhatItDoesNotKnow) {
    Dk2Bench dk2;
    const std::array<std::byte, 4> dfu{std::byte{6}};
    EXPECT_EQ(dk2.device.control_set(6, 0, dfu).error().code, ErrorCode::unsupported);
    EXPECT_EQ(dk2.device.control_set(2, 0, dfu).error().code, ErrorCode::invalid_data);
    EXPECT_EQ(dk2.device.control_set(2, 0, {}).error().code, ErrorCode::invalid_data);
    EXPECT_EQ(dk2.device.control_get(99, 0, 64).error().code, ErrorCode::unsupported);
}

TEST(SimulatedDk2, FallsSilentWhenTheKeepAliveRunsOutAndRevives) {
    Dk2Bench dk2;
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

/// Asked once in 25 s, which is longer than the headset's time-out of 10 s.
TEST(SimulatedDk2, ASlowConsumerDoesNotLetItFallAsleep) {
    for (const bool unplugged : {false, true}) {
        SimulatedDk2::Settings settings;
        settings.faults.unplug_at = 30.0;
        settings.faults.unplug_for = unplugged ? 1.0 : 0.0;
        Dk2Bench dk2(settings);
        auto source = std::move(dk2::Dk2ImuSource::open(dk2.device, dk2.clock.now())).value();
        for (int asked = 1; asked <= 6; ++asked) {
            dk2.clock.sleep_until(at(seconds(25 * asked)));
            // A fault ends a reading; what came after it follows.
            for (int reading = 0; reading < 2; ++reading) {
                while (std::holds_alternative<ImuSample>(source.next(dk2.clock.now()))) {
                }
            }
        }
        EXPECT_EQ(source.counts().lost, 0u);
        EXPECT_EQ(source.counts().reconnects, unplugged ? 1u : 0u);
        // The sample at each end is polled a tenth of a millisecond after it.
        EXPECT_EQ(source.counts().samples, unplugged ? 148998u : 149999u);
    }
}

TEST(SimulatedDk2, StaysAwakeWithoutCommandKeepAlive) {
    Dk2Bench dk2;
    ASSERT_TRUE(dk2.set(dk2::ConfigReport{.command_keep_alive = false}));
    EXPECT_EQ(dk2.reports_until(at(seconds(12))).size(), 11999u);
}

TEST(SimulatedDk2, SwitchesToTheOldReportOnReportEight) {
    Dk2Bench dk2;
    ASSERT_TRUE(dk2.set(dk2::Dk1KeepAliveReport{}));
    auto packets = dk2.packets_until(at(milliseconds(5)));
    ASSERT_FALSE(packets.empty());
    EXPECT_EQ(packets.back().bytes.size(), 62u);
    ASSERT_TRUE(dk2::InputReport1::decode(packets.back().bytes));
    ASSERT_TRUE(dk2.set(dk2::KeepAliveMuxReport{}));
    packets = dk2.packets_until(at(milliseconds(10)));
    EXPECT_EQ(packets.back().bytes.size(), 64u);
}

TEST(SimulatedDk2, LedsExposeAtTheirInterval) {
    Dk2Bench dk2;
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
    Dk2Bench a(settings), b(settings);
    settings.seed = 10;
    Dk2Bench c(settings);
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
    Dk2Bench dk2;
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

// DEVICES.md 1.5: the limits of factory.c; the firmware corrects unless its host says not to.
TEST(SimulatedDk2, TellsTheFactoryCalibrationOfItsChips) {
    Dk2Bench right, made(with("factory", 1.0, 3));
    const auto report = made.get<dk2::FactoryCalibrationReport>();
    const auto calibration = dk2::FactoryCalibration::from(report);
    const dvec3 zero_rate_rad_s = dk2::to_si(report.gyro_offset);
    for (int i = 0; i < 3; ++i) {
        EXPECT_LE(std::abs(zero_rate_rad_s[i]), glm::radians(10.0));
        EXPECT_GT(std::abs(zero_rate_rad_s[i]), 0.0);
        EXPECT_LE(std::abs(calibration.gyro_from_raw[i][i] - 1.0), 0.03);
        EXPECT_LE(std::abs(calibration.accel_from_raw[i][i] - 1.0), i == 2 ? 0.15 : 0.08);
    }
    const auto gyro_of = [](Dk2Bench& bench, int ms) {
        return dk2::to_si(bench.reports_until(at(milliseconds(ms))).back().report.slots[0].gyro);
    };
    const double as_it_comes_rad_s = glm::distance(gyro_of(right, 50), gyro_of(made, 50));
    EXPECT_LT(as_it_comes_rad_s, 2e-4);
    for (Dk2Bench* bench : {&right, &made})
        ASSERT_TRUE(bench->set(dk2::ConfigReport{.use_calibration = false}));
    EXPECT_GT(glm::distance(gyro_of(right, 100), gyro_of(made, 100)),
              0.8 * glm::length(zero_rate_rad_s));
}

}  // namespace
}  // namespace foverig
