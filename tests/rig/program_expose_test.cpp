// `foverig expose` where it refuses; tests/kernel shows it at work.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/rig/program_bench.h"

namespace foverig {
namespace {

using test::foverig;
using test::Outcome;
using testing::HasSubstr;
namespace fs = std::filesystem;

class ProgramExpose : public test::ProgramBench {};

TEST_F(ProgramExpose, OnlyAHeadsetIsAHidDevice) {
    const Outcome outcome = foverig({"expose", "gaze", "--via", "uhid"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("only a dk2 is a HID device"));
}

TEST_F(ProgramExpose, ADeviceOnTheDeskIsTheKernelsAlready) {
    const Outcome outcome = foverig({"expose", "dk2", "--devices", "hardware"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("replay:FILE"));
}

TEST_F(ProgramExpose, ARecordingIsNotWrittenOver) {
    const fs::path file = root_ / "there.mcap";
    std::ofstream(file) << "kept";
    const Outcome outcome = foverig({"expose", "dk2", "--record", file.string()});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(test::text_of(file), "kept");
}

TEST_F(ProgramExpose, SaysWhatToTypeWhereTheKernelTakesNoDevice) {
    if (fs::exists("/sys/devices/platform/vhci_hcd.0")) {
        GTEST_SKIP() << "this kernel has a virtual USB host controller";
    }
    const fs::path file = root_ / "sent.mcap";
    const Outcome outcome = foverig({"expose", "dk2", "--record", file.string()});
    EXPECT_EQ(outcome.code, 4);
    EXPECT_THAT(outcome.err, HasSubstr("sudo modprobe vhci-hcd"));
    EXPECT_FALSE(fs::exists(file)) << "a recording of nothing";
}

}  // namespace
}  // namespace foverig
