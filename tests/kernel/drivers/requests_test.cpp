// Feature reports and vendor requests, both ways, through the kernel's usbhid, hidraw and usbfs.
#include "devices/gaze/requests.h"
#include "devices/dk2/calibration_reports.h"
#include "devices/dk2/feature_reports.h"
#include "devices/dk2/identity_reports.h"
#include "devices/dk2/input_reports.h"
#include "tests/kernel/drivers/desk.h"
#include "tests/kernel/exposed.h"

namespace foverig::test {
namespace {

using namespace dk2;

template <class Report>
void expect_answer(Transport& headset, const Report& expected) {
    SCOPED_TRACE(static_cast<int>(Report::kId));
    const auto bytes = headset.control_get(Report::kId, 0, Report::kSize);
    ASSERT_TRUE(bytes) << bytes.error().text;
    EXPECT_EQ(*bytes, to_vector(expected.encode()));
}

template <class Report>
void expect_kept(Transport& headset, const Report& report) {
    SCOPED_TRACE(static_cast<int>(Report::kId));
    const auto taken = headset.control_set(Report::kId, 0, report.encode());
    ASSERT_TRUE(taken) << taken.error().text;
    expect_answer(headset, report);
}

void expect_feature_reports(Transport& headset) {
    expect_kept(headset, ConfigReport{.use_calibration = false, .interval = 1});
    expect_kept(headset, ConfigReport{});
    expect_kept(headset, RangeReport{.accel_g = 8, .gyro_deg_s = 500});
    expect_kept(headset, RegisterReport{
                             .chip = RegisterReport::Chip::lis3mdl, .address = 0x20, .payload = 7});
    expect_kept(headset, TrackingReport{.enable = true, .exposure_us = 350});
    expect_kept(headset, DisplayReport{.brightness = 77, .read_pixel = true});
    expect_kept(headset, KeepAliveMuxReport{.timeout_ms = 9000});
    expect_answer(headset, FactoryCalibrationReport{});  // 69 bytes: two packets of endpoint 0
    expect_answer(headset, DisplayInfoReport{});
    expect_answer(headset, SerialReport{0, "FOVERIGSIM01"});
    expect_answer(headset, UuidReport{0, "FOVERIGSIM01AAAAAAAA"});
    expect_answer(headset, MagCalibrationReport{});
    for (const std::uint8_t stage : std::initializer_list<std::uint8_t>{0, 1})
        expect_answer(headset, ManufacturingReport{.stage = stage});
    for (const std::uint8_t sample : std::initializer_list<std::uint8_t>{0, 1})
        expect_answer(
            headset,
            TemperatureReport{
                .bins = 7, .samples_per_bin = 5, .sample = sample, .target_centi_c = 1500});
    expect_answer(headset, GyroOffsetReport{});
    expect_answer(headset, LensDistortionReport{});
}

/// Ids of the input reports that come within a second from now on, in order, each once.
std::string input_reports(Transport& headset, const Clock& clock) {
    std::string ids;
    for (const Packet& packet : packets_until(headset, clock.now() + kSecond)) {
        const char id = read_u8(packet.bytes, 0) == InputReport1::kId ? '1' : 'B';
        const std::size_t size = id == '1' ? InputReport1::kSize : InputReport11::kSize;
        EXPECT_EQ(packet.bytes.size(), size);
        if (ids.empty() || ids.back() != id) ids += id;
    }
    return ids;
}

/// From `before` to `after` once, and not back. Of the old ones none need be left: they come each
/// millisecond, and the request may be answered before the next.
void expect_switch(const std::string& ids, char before, char after) {
    const std::string new_alone(1, after);
    EXPECT_TRUE(ids == new_alone || ids == before + new_alone) << ids;
}

class Requests : public testing::Test {
  protected:
    void SetUp() override { headset_link = headset(clock); }

    Exposed process{std::vector<std::string>{"dk2"}};
    WallClock clock;
    std::unique_ptr<hardware::LiveTransport> headset_link;
};

TEST_F(Requests, FeatureReportsGoBothWays) {
    ASSERT_TRUE(headset_link);
    expect_feature_reports(*headset_link);
}

TEST_F(Requests, UnknownFeatureReportsStall) {
    ASSERT_TRUE(headset_link);
    const auto got = headset_link->control_get(99, 0, 64);
    ASSERT_FALSE(got);
    EXPECT_EQ(got.error().code, ErrorCode::io);
    FactoryCalibrationReport report;
    EXPECT_FALSE(headset_link->control_set(FactoryCalibrationReport::kId, 0, report.encode()))
        << "the firmware only answers it";
    expect_answer(*headset_link, ConfigReport{});  // a stall does not last
}

TEST_F(Requests, AReportMayBeReadInPart) {
    ASSERT_TRUE(headset_link);
    const auto part = headset_link->control_get(FactoryCalibrationReport::kId, 0, 11);
    ASSERT_TRUE(part);
    EXPECT_EQ(*part, to_vector(Bytes(FactoryCalibrationReport{}.encode()).first(11)));
    const auto whole = headset_link->control_get(SerialReport::kId, 0, 255);
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->size(), SerialReport::kSize) << "shorter than what was asked for";
}

TEST_F(Requests, TheOldKeepAliveSwitchesTheInputReport) {
    ASSERT_TRUE(headset_link);
    EXPECT_EQ(input_reports(*headset_link, clock), "B");
    EXPECT_TRUE(
        headset_link->control_set(Dk1KeepAliveReport::kId, 0, Dk1KeepAliveReport{}.encode()));
    expect_switch(input_reports(*headset_link, clock), 'B', '1');
    EXPECT_TRUE(
        headset_link->control_set(KeepAliveMuxReport::kId, 0, KeepAliveMuxReport{}.encode()));
    expect_switch(input_reports(*headset_link, clock), '1', 'B');
}

TEST(RequestsOverUhid, FeatureAndInputReportsAreTheSame) {
    Exposed process({"dk2", "--via", "uhid"});
    WallClock clock;
    const auto headset_link = headset(clock);
    ASSERT_TRUE(headset_link);
    expect_feature_reports(*headset_link);
    EXPECT_FALSE(headset_link->control_get(99, 0, 64));
    packets_until(*headset_link, clock.now() + kSecond);
    const auto reports = packets_until(*headset_link, clock.now() + 3 * kSecond);
    EXPECT_NEAR(static_cast<double>(reports.size()), 3000.0, 30.0);
    for (std::size_t i = 1; i < reports.size(); ++i) {
        ASSERT_EQ(static_cast<std::uint16_t>(read_u16(reports[i - 1].bytes, 4) + 1),
                  read_u16(reports[i].bytes, 4))
            << "report " << i;
    }
    EXPECT_EQ(process.stop(), 0);
}

TEST(RequestsOfTracker, VendorRequestsGoBothWaysOrStall) {
    Exposed process({"gaze"});
    WallClock clock;
    const auto tracker_link = tracker(clock);
    ASSERT_TRUE(tracker_link);
    namespace request = gaze::request;

    const auto info = tracker_link->control_get(request::get_info, 0, gaze::Info::kSize);
    ASSERT_TRUE(info);
    EXPECT_EQ(gaze::Info::decode(*info)->serial, "FOVERIGSIM000001");
    const auto time = tracker_link->control_get(request::get_time, 0xBEEF, 16);
    ASSERT_TRUE(time);
    EXPECT_EQ(gaze::DeviceTimeReply::decode(*time)->cookie, 0xBEEF);
    EXPECT_TRUE(tracker_link->control_set(request::set_options, 0, gaze::encode_options(4)));
    EXPECT_TRUE(tracker_link->control_set(request::set_mapping, 0, gaze::encode_mapping(700)));
    const auto status =
        tracker_link->control_get(request::get_status, 0, gaze::DeviceStatus::kSize);
    ASSERT_TRUE(status);
    EXPECT_EQ(gaze::DeviceStatus::decode(*status)->options, 4u);
    EXPECT_EQ(gaze::DeviceStatus::decode(*status)->mapping_mm, 700.0f);

    const auto refused = [](const auto& outcome) {
        return !outcome && outcome.error().code == ErrorCode::unsupported;
    };
    EXPECT_TRUE(refused(tracker_link->control_set(request::set_rate, 61, {})));
    EXPECT_TRUE(refused(tracker_link->control_get(request::get_info, 0, 63)));
    EXPECT_TRUE(refused(tracker_link->control_get(0x55, 0, 4)));
    EXPECT_TRUE(tracker_link->control_set(request::start, 0, {})) << "a stall does not last";
    EXPECT_TRUE(refused(tracker_link->control_set(request::start, 0, {})));
}

}  // namespace
}  // namespace foverig::test
