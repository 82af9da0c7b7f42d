// The DK2 over the real hidapi, with umockdev in the kernel's place.
#include <pty.h>
#include <unistd.h>

#include <array>
#include <thread>

#include "devices/dk2/calibration_reports.h"
#include "devices/dk2/feature_reports.h"
#include "devices/dk2/imu_source.h"
#include "devices/hardware/open_devices.h"
#include "tests/devices/byte_text.h"
#include "tests/devices/hardware/other_program.h"
#include "tests/hardware/mock_headset.h"

namespace foverig::hardware {
namespace {

using test::MockBed;
using test::MockHeadset;

/// Report 11 of DEVICES.md 1.2.1.
const std::vector<std::byte> kGolden = test::bytes_of(
    "0b 07 00 02 34 12 35 0c 4e 61 bc 00 00 00 00 5f c4 80 00 00 00 00 57 ff fb 00 00 3c 00 03 c0 "
    "5f"
    "b4 3f ff 92 00 00 67 ff fb 80 00 42 34 08 34 ef dc 05 f4 01 00 50 bc 00 50 03 2c 01 00 58 bc "
    "00");

class Headset : public testing::Test {
  protected:
    void SetUp() override {
        if (!umockdev_in_mock_environment()) GTEST_SKIP() << "umockdev is not preloaded";
        // The mock headset is a pseudo-terminal; a bare chroot has no /dev/pts to make one in.
        int ends[2] = {-1, -1};
        if (openpty(&ends[0], &ends[1], nullptr, nullptr, nullptr) != 0)
            GTEST_SKIP() << "no pseudo-terminal can be opened here";
        for (const int end : ends) close(end);
    }

    Result<std::unique_ptr<LiveTransport>> open(const std::string& serial = "") {
        return open_headset(clock_, serial,
                            {.retry_period = Nanoseconds(10'000'000), .realtime = false});
    }
    HostTime soon() const { return clock_.now() + Nanoseconds(60'000'000'000); }

    WallClock clock_;
    MockBed bed_;
};

TEST_F(Headset, IsNotFoundWhereThereIsNone) {
    const auto opened = open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().code, ErrorCode::not_found);
    EXPECT_NE(opened.error().text.find("2833:0021"), std::string::npos) << opened.error().text;
    EXPECT_TRUE(find_headsets().empty());
}

TEST_F(Headset, IsFoundByItsSerial) {
    const MockHeadset first(bed_, 0, "AAAA"), second(bed_, 1, "BBBB");
    const auto found = find_headsets();
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(open().error().code, ErrorCode::invalid_data);
    EXPECT_EQ(open("CCCC").error().code, ErrorCode::not_found);
    EXPECT_EQ(choose_headset("BBBB")->path, second.node());
    EXPECT_TRUE(open("BBBB"));
}

TEST_F(Headset, IsFoundByItsFactoryNumberToo) {
    MockHeadset first(bed_, 0, "AAAA"), second(bed_, 1, "BBBB");
    second.answer(test::copy_of(dk2::SerialReport{.serial = "ABCDEFGHIJKL"}.encode()));
    const auto chosen = choose_headset("ABCDEFGHIJKL");
    ASSERT_TRUE(chosen) << chosen.error().text;
    EXPECT_EQ(chosen->serial, "BBBB");
    EXPECT_EQ(choose_headset("ABCDEFGHIJKX").error().code, ErrorCode::not_found);
}

/// One that another program holds is not asked its number: it may be the one that is meant.
TEST_F(Headset, OfABusyOneIsToldInsteadOfThatNoneHasTheNumber) {
    MockHeadset busy(bed_, 0, "AAAA"), free(bed_, 1, "BBBB");
    busy.answer(test::copy_of(dk2::SerialReport{.serial = "MNOPQRSTUVWX"}.encode()));
    free.answer(test::copy_of(dk2::SerialReport{.serial = "ABCDEFGHIJKL"}.encode()));
    const test::OtherProgram other(busy.node());
    const auto chosen = choose_headset("MNOPQRSTUVWX");
    ASSERT_FALSE(chosen);
    EXPECT_EQ(chosen.error().code, ErrorCode::busy) << "not_found would be simulated under auto";
    EXPECT_NE(chosen.error().text.find(busy.node()), std::string::npos) << chosen.error().text;
    EXPECT_EQ(open("MNOPQRSTUVWX").error().code, ErrorCode::busy);
    EXPECT_EQ(choose_headset("ABCDEFGHIJKL")->serial, "BBBB") << "one that does answer is taken";
    EXPECT_EQ(choose_headset("BBBB")->path, free.node());
}

TEST_F(Headset, GivesReportsByteForByteWithTheirArrival) {
    MockHeadset headset(bed_);
    const auto device = open();
    ASSERT_TRUE(device) << device.error().text;
    const HostTime before = clock_.now();
    headset.send(kGolden);
    const auto next = (*device)->next(soon());
    const auto* packet = std::get_if<Packet>(&next);
    ASSERT_NE(packet, nullptr);
    EXPECT_EQ(packet->bytes, kGolden);
    EXPECT_GE(packet->arrival, before);
    EXPECT_LE(packet->arrival, clock_.now());
    EXPECT_TRUE(std::holds_alternative<Timeout>((*device)->next(clock_.now())));
}

TEST_F(Headset, CarriesFeatureReportsBothWays) {
    MockHeadset headset(bed_);
    const auto device = open();
    ASSERT_TRUE(device) << device.error().text;
    const auto config = test::copy_of(dk2::ConfigReport{.command_id = 9, .interval = 1}.encode());
    ASSERT_TRUE((*device)->control_set(dk2::ConfigReport::kId, 0, config));
    ASSERT_EQ(headset.sets().size(), 1U);
    EXPECT_EQ(headset.sets()[0], config);
    headset.answer(config);
    EXPECT_EQ(*(*device)->control_get(dk2::ConfigReport::kId, 0, config.size()), config);
    const auto unknown = (*device)->control_get(19, 0, 23);
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, ErrorCode::io);
}

/// Unplugged: a fault, for good. Plugged in again: reports, and it was set up as at first.
TEST_F(Headset, ComesBackAndIsSetUpAgain) {
    const auto answer_all = [](MockHeadset& headset) {
        headset.answer(test::copy_of(dk2::FactoryCalibrationReport{}.encode()));
        headset.answer(test::copy_of(dk2::ConfigReport{}.encode()));
        headset.answer(test::copy_of(dk2::DisplayReport{}.encode()));
    };
    auto headset = std::make_unique<MockHeadset>(bed_);
    answer_all(*headset);
    const auto device = open();
    ASSERT_TRUE(device) << device.error().text;
    // Only what sets it up is counted, however long this takes.
    auto source = dk2::Dk2ImuSource::open(**device, clock_.now(),
                                          {.keep_alive_period = std::chrono::hours(1)});
    ASSERT_TRUE(source) << source.error().text;
    auto& imu = const_cast<dk2::Dk2ImuSource&>(*source);
    headset->send(kGolden);
    ASSERT_TRUE(std::holds_alternative<ImuSample>(imu.next(soon())));
    ASSERT_TRUE(std::holds_alternative<ImuSample>(imu.next(soon())));
    const auto first_sets = headset->sets().size();

    headset->unplug();
    auto next = imu.next(soon());
    ASSERT_TRUE(std::holds_alternative<Fault>(next));
    EXPECT_EQ(std::get<Fault>(next).error.code, ErrorCode::closed);
    EXPECT_FALSE((*device)->control_get(dk2::ConfigReport::kId, 0, 7));

    headset.reset();
    headset = std::make_unique<MockHeadset>(bed_, 1);
    answer_all(*headset);
    while (std::holds_alternative<Fault>(imu.next(clock_.now()))) std::this_thread::yield();
    auto later = kGolden;
    later[8] = std::byte{0x4F};  // a microsecond on
    headset->send(later);
    EXPECT_TRUE(std::holds_alternative<ImuSample>(imu.next(soon())));
    EXPECT_EQ(headset->sets().size(), first_sets);
}

/// Whose session is at work for long and asks for nothing.
TEST_F(Headset, IsKeptAwakeByTheThreadThatReadsIt) {
    MockHeadset headset(bed_);
    headset.answer(test::copy_of(dk2::FactoryCalibrationReport{}.encode()));
    headset.answer(test::copy_of(dk2::ConfigReport{}.encode()));
    headset.answer(test::copy_of(dk2::DisplayReport{}.encode()));
    const auto device = open();
    ASSERT_TRUE(device) << device.error().text;
    const auto source = dk2::Dk2ImuSource::open(**device, clock_.now(),
                                                {.keep_alive_period = Nanoseconds(10'000'000)});
    ASSERT_TRUE(source) << source.error().text;
    const auto set_up = headset.sets();
    const HostTime deadline = soon();
    while (headset.sets().size() < set_up.size() + 3 && clock_.now() < deadline)
        std::this_thread::yield();
    const auto sets = headset.sets();
    ASSERT_GE(sets.size(), set_up.size() + 3);
    EXPECT_EQ(dk2::KeepAliveMuxReport::decode(set_up.back())->timeout_ms, 10000);
    for (std::size_t i = set_up.size(); i < sets.size(); ++i) EXPECT_EQ(sets[i], set_up.back());
}

/// Each keep-alive that runs out of time holds the reports up: after the first, which another
/// follows at once, they rest as requests do.
TEST_F(Headset, IsNotKeptBusyWithKeepAlivesThatRunOutOfTime) {
    MockHeadset headset(bed_);
    const auto device = open();
    ASSERT_TRUE(device) << device.error().text;
    const std::chrono::milliseconds takes(120);
    headset.let_sets_run_out_of_time(takes);
    const auto report = dk2::KeepAliveMuxReport{}.encode();
    (*device)->keep_awake(dk2::KeepAliveMuxReport::kId, report, Nanoseconds(1'000'000));
    const HostTime deadline = soon();
    while (headset.lost_sets().size() < 4 && clock_.now() < deadline)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const auto lost = headset.lost_sets();
    ASSERT_GE(lost.size(), 4U);
    EXPECT_GE(lost[2] - lost[1], 2 * takes);
    EXPECT_GE(lost[3] - lost[2], 5 * takes);
}

/// Nobody asked for it.
TEST_F(Headset, IsSentNothingUnasked) {
    MockHeadset headset(bed_);
    const auto device = open();
    ASSERT_TRUE(device) << device.error().text;
    for (int i = 0; i < 20; ++i) {
        headset.send(kGolden);
        ASSERT_TRUE(std::holds_alternative<Packet>((*device)->next(soon())));
    }
    EXPECT_TRUE(headset.sets().empty());
}

}  // namespace
}  // namespace foverig::hardware
