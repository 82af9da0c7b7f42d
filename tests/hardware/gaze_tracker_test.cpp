// The gaze tracker over the real libusb, with umockdev in the kernel's place.
#include <thread>

#include "devices/gaze/calibration.h"
#include "devices/gaze/calibration_targets.h"
#include "devices/gaze/gaze_source.h"
#include "devices/hardware/open_devices.h"
#include "tests/devices/byte_text.h"
#include "tests/devices/gaze/golden_sample.h"
#include "tests/hardware/mock_tracker.h"

namespace foverig::hardware {
namespace {

using test::MockBed;
using test::MockTracker;
namespace request = gaze::request;

const std::vector<std::byte> kGolden = test::bytes_of(test::kGoldenSampleHex);

/// As a tracker's firmware answers; the rest stalls.
std::optional<std::vector<std::byte>> firmware(const MockTracker::Request& r) {
    if (r.id == request::get_info) return test::copy_of(gaze::Info{.serial = "ABC"}.encode());
    if (r.id == request::get_time) {
        return test::copy_of(
            gaze::DeviceTimeReply{.device_ns = 1'000'012'000'000, .cookie = r.value}.encode());
    }
    return std::nullopt;
}

class Tracker : public testing::Test {
  protected:
    void SetUp() override {
        if (!umockdev_in_mock_environment()) GTEST_SKIP() << "umockdev is not preloaded";
    }

    Result<std::unique_ptr<LiveTransport>> open() {
        return open_gaze_tracker(clock_, kGazeTracker, "",
                                 {.retry_period = Nanoseconds(10'000'000), .realtime = false});
    }
    HostTime soon() const { return clock_.now() + Nanoseconds(60'000'000'000); }
    static void send(MockTracker& tracker, const std::vector<std::byte>& frame) {
        while (!tracker.send(frame)) std::this_thread::yield();
    }

    WallClock clock_;
    MockBed bed_;
};

TEST_F(Tracker, IsNotFoundWhereThereIsNone) {
    const auto opened = open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().code, ErrorCode::not_found);
    EXPECT_NE(opened.error().text.find("1209:0001"), std::string::npos) << opened.error().text;
}

TEST_F(Tracker, IsFoundWithItsSerial) {
    MockTracker tracker(bed_);
    const auto found = find_gaze_trackers(kGazeTracker);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].path, MockTracker::kNode);
    EXPECT_EQ(found[0].serial, "0123456789ABCDEF");
    EXPECT_FALSE(found[0].problem) << found[0].problem->text;
    EXPECT_TRUE(find_gaze_trackers({0x1209, 0x0002}).empty());
}

TEST_F(Tracker, KeepsEightTransfersQueuedAndGivesFramesByteForByte) {
    MockTracker tracker(bed_);
    const auto device = open();
    ASSERT_TRUE(device) << device.error().text;
    for (int i = 0; i < 20; ++i) {
        auto frame = kGolden;
        frame[12] = static_cast<std::byte>(i);
        send(tracker, frame);
        const auto next = (*device)->next(soon());
        const auto* packet = std::get_if<Packet>(&next);
        ASSERT_NE(packet, nullptr) << i;
        EXPECT_EQ(packet->bytes, frame);
    }
    while (tracker.waiting() < 8) std::this_thread::yield();
    EXPECT_EQ(tracker.waiting(), 8U);
}

TEST_F(Tracker, CarriesVendorRequestsToTheInterface) {
    MockTracker tracker(bed_);
    tracker.answer = firmware;
    const auto device = open();
    ASSERT_TRUE(device) << device.error().text;
    EXPECT_EQ(gaze::Info::decode(*(*device)->control_get(request::get_info, 0, 64))->serial, "ABC");
    ASSERT_TRUE((*device)->control_set(request::set_mapping, 0, gaze::encode_mapping(2000)));
    const auto last = tracker.requests().back();
    EXPECT_EQ(last.type, 0x41);
    EXPECT_EQ(last.id, request::set_mapping);
    EXPECT_EQ(last.index, 0);
    EXPECT_EQ(*gaze::decode_mapping(last.data), 2000);
    const auto refused = (*device)->control_get(request::get_status, 0, 32);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::unsupported) << refused.error().text;
}

TEST_F(Tracker, CarriesACalibrationBothWays) {
    MockTracker tracker(bed_);
    const gaze::CalibrationBlob stored{.id = 3, .data = {std::byte{13}, std::byte{90}}};
    tracker.answer = [&](const MockTracker::Request& r) -> std::optional<std::vector<std::byte>> {
        if (r.id == request::cal_blob) return test::copy_of(stored.encode());
        if (r.id != request::get_info) return firmware(r);
        return test::copy_of(
            gaze::Info{.capabilities = gaze::capability::save_calibration, .serial = "ABC"}
                .encode());
    };
    const auto device = open();
    ASSERT_TRUE(device) << device.error().text;
    const auto blob = (*device)->control_get(request::cal_blob, 0, gaze::CalibrationBlob::kSize);
    ASSERT_TRUE(blob) << blob.error().text;
    EXPECT_EQ(*gaze::CalibrationBlob::decode(*blob), stored);

    // A run gives it back before START.
    const gaze::GazeSourceConfig config{.calibration = gaze::StoredCalibration{"ABC", *blob}};
    auto opened = gaze::GazeSource::open(**device, clock_, config);
    ASSERT_TRUE(opened) << opened.error().text;
    gaze::GazeSource source = std::move(opened).value();
    std::vector<MockTracker::Request> orders;
    for (const auto& r : tracker.requests())
        if (r.type == 0x41) orders.push_back(r);
    ASSERT_EQ(orders.size(), 6U);
    EXPECT_EQ(orders[4].id, request::cal_blob);
    EXPECT_EQ(orders[4].data, *blob);
    EXPECT_EQ(orders[5].id, request::start);

    gaze::CalibrationProcedure procedure(gaze::CalibrationProcedure::Task::calibrate,
                                         gaze::targets_deg(13, 16.0), clock_.now());
    const auto order = procedure.next_order(clock_.now());
    ASSERT_TRUE(order);
    ASSERT_TRUE((*device)->control_set(order->request, order->value, order->data));
    const auto sent = tracker.requests().back();
    EXPECT_EQ(sent.id, request::cal_start);
    EXPECT_EQ(sent.value, 13);
    EXPECT_EQ(sent.data.size(), 13U * 8U);
    EXPECT_EQ(sent.data, order->data);

    gaze::CalibrationFrame waiting{.points = 13, .state = gaze::CalibrationState::waiting};
    waiting.header.session = 9;
    send(tracker, test::copy_of(waiting.encode()));
    gaze::SampleFrame sample = test::golden_sample();
    sample.header.session = 9;
    sample.header.sequence = 1;
    send(tracker, test::copy_of(sample.encode()));
    ASSERT_TRUE(std::holds_alternative<GazeSample>(source.next(soon())));
    for (const auto& frame : source.take_calibrations()) procedure.take(frame, clock_.now());
    EXPECT_EQ(procedure.shown(), 0U);
}

TEST_F(Tracker, RefusesACalibrationOfAnother) {
    MockTracker tracker(bed_);
    tracker.answer = firmware;
    const auto device = open();
    ASSERT_TRUE(device) << device.error().text;
    const auto other = gaze::GazeSource::open(**device, clock_,
                                              {.calibration = gaze::StoredCalibration{"XYZ", {}}});
    ASSERT_FALSE(other);
    EXPECT_NE(other.error().text.find("is of tracker XYZ, and this is ABC"), std::string::npos);
    const auto unable = gaze::GazeSource::open(**device, clock_,
                                               {.calibration = gaze::StoredCalibration{"ABC", {}}});
    ASSERT_FALSE(unable);
    EXPECT_EQ(unable.error().code, ErrorCode::unsupported) << unable.error().text;
}

TEST_F(Tracker, HeldByAnotherProgramIsBusy) {
    MockTracker tracker(bed_);
    tracker.claimed_by_another = true;
    const auto opened = open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().code, ErrorCode::busy) << opened.error().text;
}

TEST_F(Tracker, GoesOnBehindAHaltThatWasClearedAndCountsIt) {
    MockTracker tracker(bed_);
    tracker.answer = firmware;
    const auto device = open();
    ASSERT_TRUE(device) << device.error().text;
    EXPECT_EQ(tracker.clears(), 1) << "whoever had it before may have left it halted";
    auto source = gaze::GazeSource::open(**device, clock_).value();
    gaze::SampleFrame frame = test::golden_sample();
    for (int i = 0; i < 3; ++i) {
        ++frame.header.sequence;
        send(tracker, test::copy_of(frame.encode()));
        ASSERT_TRUE(std::holds_alternative<GazeSample>(source.next(soon()))) << i;
        while (!tracker.halt()) std::this_thread::yield();
        ++frame.header.sequence;
        send(tracker, test::copy_of(frame.encode()));
        ASSERT_TRUE(std::holds_alternative<GazeSample>(source.next(soon()))) << i;
    }
    EXPECT_EQ(tracker.clears(), 4);
    EXPECT_EQ(source.counts().rejected, 3U);
    EXPECT_EQ(source.counts().lost, 0U);
    EXPECT_EQ(source.counts().reconnects, 0U);
}

TEST_F(Tracker, ThatHaltsAgainAndAgainIsAFault) {
    MockTracker tracker(bed_);
    const auto device = open();
    ASSERT_TRUE(device) << device.error().text;
    tracker.stays_halted = true;
    while (!tracker.halt()) std::this_thread::yield();
    auto next = (*device)->next(soon());
    while (std::holds_alternative<Packet>(next)) next = (*device)->next(soon());
    ASSERT_TRUE(std::holds_alternative<Fault>(next));
    EXPECT_NE(std::get<Fault>(next).error.text.find("again and again"), std::string::npos);
}

/// A tracker is idle when it was plugged in again: it is started anew.
TEST_F(Tracker, ComesBackAndIsStartedAgain) {
    auto tracker = std::make_unique<MockTracker>(bed_);
    tracker->answer = firmware;
    const auto device = open();
    ASSERT_TRUE(device) << device.error().text;
    auto opened = gaze::GazeSource::open(**device, clock_);
    ASSERT_TRUE(opened) << opened.error().text;
    gaze::GazeSource source = std::move(opened).value();
    send(*tracker, kGolden);
    ASSERT_TRUE(std::holds_alternative<GazeSample>(source.next(soon())));

    tracker->unplug();
    const auto gone = source.next(soon());
    ASSERT_TRUE(std::holds_alternative<Fault>(gone));
    EXPECT_EQ(std::get<Fault>(gone).error.code, ErrorCode::closed);

    tracker.reset();
    tracker = std::make_unique<MockTracker>(bed_);
    tracker->answer = firmware;
    const auto started = [&] {
        const auto requests = tracker->requests();
        return std::any_of(requests.begin(), requests.end(),
                           [](const auto& r) { return r.type == 0x41 && r.id == request::start; });
    };
    for (const HostTime until = soon(); !started() && clock_.now() < until;) {
        (void)source.next(clock_.now());
    }
    EXPECT_TRUE(started());
    gaze::SampleFrame again = test::golden_sample();
    again.header.session = 7;
    again.header.sequence = 0;
    send(*tracker, test::copy_of(again.encode()));
    ASSERT_TRUE(std::holds_alternative<GazeSample>(source.next(soon())));
    EXPECT_EQ(source.counts().reconnects, 1U);
}

}  // namespace
}  // namespace foverig::hardware
