#include "rig/records/panel_record.h"

#include <gtest/gtest.h>

namespace foverig {
namespace {

FrameRecord shown(std::uint64_t vsync_number, double vsync_s) {
    FrameRecord frame;
    frame.shown_vsync = vsync_number;
    frame.vsync = HostTime(from_seconds(vsync_s));
    return frame;
}

TEST(PanelRecord, HasNothingToSayOfARunThatShowedNothing) {
    EXPECT_EQ(panel_record({}).samples, 0U);
    EXPECT_FALSE(panel_record({}).rate_hz);
    EXPECT_FALSE(panel_record({FrameRecord{}}).rate_hz);
    EXPECT_FALSE(panel_record({shown(3, 0.04)}).rate_hz) << "one scan-out has no rate";
}

TEST(PanelRecord, CountsRepeatedScanOutsButNoDroppedFrame) {
    // 90 Hz: VSyncs 10, 11 and, after a repeat, 13; the last frame was never shown.
    const std::vector<FrameRecord> frames{shown(10, 1.0), shown(11, 1.0 + 1.0 / 90.0),
                                          shown(13, 1.0 + 3.0 / 90.0), FrameRecord{}};
    EXPECT_NEAR(panel_record(frames).rate_hz.value_or(0.0), 90.0, 1e-4);
}

TEST(PanelRecord, SamplesAreFramesThatWereReadBack) {
    std::vector<FrameRecord> frames{shown(1, 0.1), shown(2, 0.2), shown(3, 0.3)};
    frames[1].readback_scan_out = frames[1].vsync;
    EXPECT_EQ(panel_record(frames).samples, 1U);
}

}  // namespace
}  // namespace foverig
