// What `foverig doctor` says of devices, over the real hidapi and libusb, with umockdev in the
// kernel's place.
#include "rig/doctor_devices.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <pty.h>

#include "devices/dk2/calibration_reports.h"
#include "devices/dk2/feature_reports.h"
#include "devices/dk2/identity_reports.h"
#include "tests/devices/byte_text.h"
#include "tests/devices/hardware/other_program.h"
#include "tests/hardware/mock_headset.h"
#include "tests/hardware/mock_tracker.h"

namespace foverig {
namespace {

using test::MockBed;
using test::MockHeadset;
using test::MockTracker;
using testing::HasSubstr;

class Doctor : public testing::Test {
  protected:
    void SetUp() override {
        if (!umockdev_in_mock_environment()) GTEST_SKIP() << "umockdev is not preloaded";
        int ends[2] = {-1, -1};
        if (openpty(&ends[0], &ends[1], nullptr, nullptr, nullptr) != 0)
            GTEST_SKIP() << "no pseudo-terminal can be opened here";
        for (const int end : ends) close(end);
    }

    static std::string said_of(const std::string& device) {
        for (const DoctorRow& row : examine_devices()) {
            if (row.name == device) return row.text;
        }
        return "no such row";
    }
    static void answer_as_made(MockHeadset& headset) {
        headset.answer(test::copy_of(dk2::SerialReport{.serial = "ABCDEFGHIJKL"}.encode()));
        headset.answer(test::copy_of(dk2::UuidReport{.uuid = "ABCDEFGHIJKLMNOPQRST"}.encode()));
        headset.answer(test::copy_of(
            dk2::ManufacturingReport{.stages = 1, .unix_time_s = 1405123200, .result = 1}
                .encode()));
        headset.answer(test::copy_of(dk2::MagCalibrationReport{.version = 1}.encode()));
        headset.answer(test::copy_of(dk2::RangeReport{}.encode()));
        headset.answer(test::copy_of(dk2::RegisterReport{}.encode()));
    }

    MockBed bed_;
};

TEST_F(Doctor, SaysWhatIsNotThere) {
    EXPECT_THAT(said_of("headset"), HasSubstr("none seen (Rift DK2, USB 2833:0021)"));
    EXPECT_THAT(said_of("gaze tracker"), HasSubstr("none seen (SGZ1, USB 1209:0001)"));
    EXPECT_THAT(said_of("tracker camera"), HasSubstr("none seen (DK2's camera, USB 2833:0201)"));
}

TEST_F(Doctor, SaysWhatAHeadsetSaysOfItself) {
    MockHeadset headset(bed_);
    answer_as_made(headset);
    EXPECT_EQ(said_of("headset"),
              "/dev/hidraw0 ready, serial A1B2C3D4E5F6G7H8I9J0, factory number ABCDEFGHIJKL, UUID "
              "ABCDEFGHIJKLMNOPQRST; made "
              "2014-07-12, 1 factory tests stored, all passed; magnetometer calibrated (version "
              "1)");
    EXPECT_TRUE(headset.sets().empty());
}

TEST_F(Doctor, SaysThatAHeadsetDoesNotAnswer) {
    MockHeadset headset(bed_);
    EXPECT_THAT(said_of("headset"), HasSubstr("/dev/hidraw0 ready, serial A1B2C3D4E5F6G7H8I9J0, "
                                              "but /dev/hidraw0 did not give feature report 10"));
}

TEST_F(Doctor, SaysWhichProgramHoldsTheHeadset) {
    MockHeadset headset(bed_);
    answer_as_made(headset);
    const test::OtherProgram other(headset.node());
    EXPECT_EQ(
        said_of("headset"),
        fmt::format("/dev/hidraw0 is held by sleep (pid {}); end that program first", other.pid()));
}

TEST_F(Doctor, SaysWhichProgramHoldsTheGazeTracker) {
    MockTracker tracker(bed_);
    tracker.claimed_by_another = true;
    const test::OtherProgram other(MockTracker::kNode);
    EXPECT_EQ(said_of("gaze tracker"),
              fmt::format("{} is held by sleep (pid {}); end that program first",
                          MockTracker::kNode, other.pid()));
}

}  // namespace
}  // namespace foverig
