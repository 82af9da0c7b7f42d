#include "rig/doctor_display.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foverig {
namespace {

using testing::HasSubstr;
using window::Monitor;

const Monitor kDesk{"DP-1", {1920, 1080}, 60, 520, 290};
const Monitor kPanel{"HDMI-1", {1080, 1920}, 75, 71, 126};
const Connector kHeadset{"HDMI-A-1", true, false, Edid{"OVR", 3, "Rift DK2"}};

TEST(DoctorDisplay, ListsMonitorsAndThePanelAmongThem) {
    const auto rows = display_rows(std::vector{kDesk, kPanel}, {kHeadset});
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_THAT(rows[0].text, HasSubstr("DP-1 (1920x1080 at 60 Hz, 520x290 mm); HDMI-1"));
    EXPECT_THAT(rows[1].text, HasSubstr("ready for --display headset"));
}

TEST(DoctorDisplay, SaysWhatToTypeForAPanelThatTheKernelHides) {
    const auto rows = display_rows(std::vector{kDesk}, {kHeadset});
    EXPECT_THAT(rows[1].text, HasSubstr("OVR Rift DK2 is plugged in at HDMI-A-1"));
    EXPECT_THAT(rows[1].text, HasSubstr("xrandr --output HDMI-1 --set non-desktop 0"));
}

TEST(DoctorDisplay, SeesNoPanelInOtherMonitors) {
    const Connector desk{"DP-1", true, true, Edid{"DEL", 1, "U2412M"}};
    const Connector gone{"HDMI-A-1", false, false, Edid{"OVR", 3, "Rift DK2"}};
    EXPECT_THAT(display_rows(std::vector{kDesk}, {desk, gone})[1].text, HasSubstr("none seen"));
}

TEST(DoctorDisplay, WithoutADesktopSaysWhy) {
    const Error none{ErrorCode::not_found, "there is no desktop to open a window on (why)"};
    const auto rows = display_rows(none, {kHeadset});
    EXPECT_THAT(rows[0].text, HasSubstr("(why): --display window cannot be used here"));
    EXPECT_THAT(rows[1].text, HasSubstr("non-desktop"));
}

}  // namespace
}  // namespace foverig
