// What goes through a RecordedTransport comes out of a ReplayedDevice.
#include "simulators/replay/replayed_device.h"

#include <gtest/gtest.h>

#include "devices/recording/recorded_transport.h"
#include "tests/devices/byte_text.h"
#include "tests/devices/fake_transport.h"
#include "tests/devices/recording/memory_sink.h"

namespace foverig {
namespace {

using test::bytes_of;

HostTime at_ms(int ms) {
    return HostTime(Nanoseconds(std::int64_t{ms} * 1'000'000));
}

class ReplayedDeviceTest : public testing::Test {
  protected:
    /// A device that answers, sends at 10, 20 and 30 ms, is out at 40, and sends again at 60 ms.
    void SetUp() override {
        auto recorder = Recorder::begin(std::make_unique<test::MemorySink>(disk_)).value();
        test::FakeTransport device;
        ManualClock clock;
        RecordedTransport tap(device, *recorder, clock,
                              {.name = "dk2", .packet_encoding = "x-hid", .device_time = ""});
        device.answers[3] = bytes_of("03 AA BB");
        EXPECT_TRUE(tap.control_get(3, 0, 3));
        EXPECT_FALSE(tap.control_get(4, 0, 3));
        EXPECT_TRUE(tap.control_set(17, 0, bytes_of("11 00")));
        for (const int ms : {10, 20, 30}) {
            clock.sleep_until(at_ms(ms));
            device.push(at_ms(ms), bytes_of("0B 00"));
            EXPECT_TRUE(std::holds_alternative<Packet>(tap.next(at_ms(ms))));
            device.answers[5] = {static_cast<std::byte>(ms)};
            EXPECT_TRUE(tap.control_get(5, static_cast<std::uint16_t>(ms), 1));
        }
        clock.sleep_until(at_ms(40));
        device.fault_at_end = Error{ErrorCode::closed, "the cable is out"};
        for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::holds_alternative<Fault>(tap.next(at_ms(40))));
        clock.sleep_until(at_ms(60));
        device.push(at_ms(60), bytes_of("0B 01 02"));
        EXPECT_TRUE(std::holds_alternative<Packet>(tap.next(at_ms(60))));
        EXPECT_TRUE(recorder->close());
        bytes_ = disk_.bytes();
        recording_ = Recording::open(std::make_unique<MemorySource>(bytes_), "test.mcap").value();
    }

    ReplayedDevice device(ReplayedDevice::Settings settings = {}) {
        return {*recording_, "dk2", clock_, settings};
    }

    test::Disk disk_;
    std::vector<std::byte> bytes_;
    std::optional<Recording> recording_;
    ManualClock clock_;
};

TEST_F(ReplayedDeviceTest, GivesPacketsWhenTheyCameAndWaitsForThem) {
    ReplayedDevice d = device();
    EXPECT_TRUE(std::holds_alternative<Timeout>(d.next(at_ms(9))));
    EXPECT_EQ(clock_.now(), at_ms(9));
    for (const int ms : {10, 20, 30}) {
        const auto got = d.next(at_ms(35));
        ASSERT_TRUE(std::holds_alternative<Packet>(got));
        EXPECT_EQ(std::get<Packet>(got).arrival, at_ms(ms));
        EXPECT_EQ(std::get<Packet>(got).bytes, bytes_of("0B 00"));
        EXPECT_EQ(clock_.now(), at_ms(ms));
    }
    EXPECT_TRUE(std::holds_alternative<Timeout>(d.next(at_ms(35))));
    const auto out = d.next(at_ms(50));
    ASSERT_TRUE(std::holds_alternative<Fault>(out));
    EXPECT_EQ(std::get<Fault>(out).error.text, "the cable is out");
    EXPECT_FALSE(d.control_set(17, 0, {}));
    clock_.sleep_until(at_ms(59));
    EXPECT_TRUE(std::holds_alternative<Fault>(d.next(at_ms(59)))) << "until the cable is in again";
    clock_.sleep_until(at_ms(100));
    const auto again = d.next(at_ms(100));
    ASSERT_TRUE(std::holds_alternative<Packet>(again));
    EXPECT_EQ(std::get<Packet>(again).bytes, bytes_of("0B 01 02"));
    EXPECT_TRUE(std::holds_alternative<EndOfStream>(d.next(at_ms(200))));
    EXPECT_TRUE(d.at_end());
    EXPECT_TRUE(d.control_set(17, 0, {}));
}

TEST_F(ReplayedDeviceTest, AnswersWhatWasAnsweredAndRefusesTheRest) {
    ReplayedDevice d = device();
    EXPECT_EQ(d.control_get(3, 0, 3).value(), bytes_of("03 AA BB"));
    EXPECT_EQ(d.control_get(4, 0, 3).error().text, "no answer scripted") << "as the device did";
    EXPECT_FALSE(d.control_get(3, 1, 3)) << "another value";
    EXPECT_FALSE(d.control_get(3, 0, 4)) << "another size";
    EXPECT_FALSE(d.control_get(9, 0, 3)) << "never asked";
}

TEST_F(ReplayedDeviceTest, AnAnswerOfTheMomentHoldsOnlyAtThatMoment) {
    ReplayedDevice d = device({.momentary_request = 5});
    clock_.sleep_until(at_ms(10));
    EXPECT_TRUE(std::holds_alternative<Packet>(d.next(at_ms(10))));
    EXPECT_EQ(d.control_get(5, 10, 1).value(), bytes_of("0A"));
    clock_.sleep_until(at_ms(11));
    EXPECT_FALSE(d.control_get(5, 10, 1));
    EXPECT_EQ(d.control_get(3, 0, 3).value(), bytes_of("03 AA BB")) << "others do not age";
}

TEST_F(ReplayedDeviceTest, BeginsAgainInALoopAtTimesThatGoOn) {
    ReplayedDevice d = device({.loop = true});
    std::vector<HostTime> arrivals;
    while (clock_.now() < at_ms(300)) {
        const auto got = d.next(at_ms(300));
        if (const auto* packet = std::get_if<Packet>(&got)) arrivals.push_back(packet->arrival);
        if (std::holds_alternative<Fault>(got)) clock_.advance(Nanoseconds(1'000'000));
        ASSERT_FALSE(std::holds_alternative<EndOfStream>(got));
    }
    // The recording spans 0 to 60 ms, and a round begins 1 ms after the last one's end.
    ASSERT_GE(arrivals.size(), 16U);
    for (std::size_t i = 4; i < arrivals.size(); ++i) {
        EXPECT_EQ(arrivals[i] - arrivals[i - 4], Nanoseconds(61'000'000)) << i;
    }
}

/// Unplugged for good at 40 ms of a recording that goes on to 100 ms.
TEST(ReplayedDevice, WhatEndedUnpluggedIsPluggedInWhenALoopBeginsAgain) {
    test::Disk disk;
    {
        auto recorder = Recorder::begin(std::make_unique<test::MemorySink>(disk)).value();
        test::FakeTransport device;
        ManualClock clock;
        RecordedTransport tap(device, *recorder, clock,
                              {.name = "dk2", .packet_encoding = "x-hid", .device_time = ""});
        EXPECT_FALSE(tap.control_get(3, 0, 3));
        device.push(at_ms(10), bytes_of("0B 00"));
        EXPECT_TRUE(std::holds_alternative<Packet>(tap.next(at_ms(10))));
        clock.sleep_until(at_ms(40));
        device.fault_at_end = Error{ErrorCode::closed, "the cable is out"};
        EXPECT_TRUE(std::holds_alternative<Fault>(tap.next(at_ms(40))));
        const auto other = recorder->add_topic({.topic = "/other", .message_encoding = "x"});
        recorder->record(other, at_ms(100), at_ms(100), bytes_of("00"));
        EXPECT_TRUE(recorder->close());
    }
    const auto bytes = disk.bytes();
    const auto recording =
        Recording::open(std::make_unique<MemorySource>(bytes), "test.mcap").value();
    ManualClock clock;
    ReplayedDevice d(recording, "dk2", clock, {.loop = true});
    const auto outcome_at = [&](int ms) {
        clock.sleep_until(at_ms(ms));
        return d.next(at_ms(ms));
    };
    constexpr int kRound = 101;
    for (const int begin : {0, kRound, 2 * kRound}) {
        EXPECT_TRUE(std::holds_alternative<Timeout>(outcome_at(begin + 1))) << begin;
        EXPECT_TRUE(d.control_set(17, 0, {})) << begin;
        EXPECT_TRUE(std::holds_alternative<Packet>(outcome_at(begin + 10))) << begin;
        EXPECT_TRUE(std::holds_alternative<Timeout>(outcome_at(begin + 39))) << begin;
        for (const int ms : {40, 41, 99}) {
            EXPECT_TRUE(std::holds_alternative<Fault>(outcome_at(begin + ms))) << begin + ms;
            EXPECT_FALSE(d.control_set(17, 0, {}));
        }
    }
}

/// A damaged chunk in the middle: its checksum says so when it is reached, as the device's fault.
TEST_F(ReplayedDeviceTest, SaysThatTheFileIsDamaged) {
    const auto chunk = recording_->summary().chunks.at(0);
    bytes_[chunk.offset + 60] ^= std::byte{1};
    ReplayedDevice d = device();
    const auto got = d.next(at_ms(100));
    ASSERT_TRUE(std::holds_alternative<Fault>(got));
    EXPECT_NE(std::get<Fault>(got).error.text.find("checksum"), std::string::npos);
    EXPECT_TRUE(d.damage());
}

}  // namespace
}  // namespace foverig
