#include "rig/live/recent_frames.h"

#include <gtest/gtest.h>

namespace foverig {
namespace {

FrameRecord frame_of(double frame_ms, std::uint64_t vsync) {
    FrameRecord frame;
    frame.present = frame.begin + from_seconds(1e-3 * frame_ms);
    frame.shown_vsync = vsync;
    return frame;
}

TEST(RecentFrames, KeepsTheLast240) {
    RecentFrames recent;
    for (int i = 0; i < 300; ++i) recent.add(frame_of(i, static_cast<std::uint64_t>(i)));
    ASSERT_EQ(recent.frame_ms().size(), 240U);
    EXPECT_FLOAT_EQ(recent.frame_ms().front(), 60.0F);
    EXPECT_FLOAT_EQ(recent.frame_ms().back(), 299.0F);
    EXPECT_EQ(recent.dropped(), 0U);
}

TEST(RecentFrames, CountsWhatNobodySaw) {
    RecentFrames recent;
    recent.add(frame_of(5.0, 10));
    recent.add(frame_of(5.0, 10));
    FrameRecord late = frame_of(30.0, 13);
    late.missed_vsyncs = 2;
    recent.add(late);
    EXPECT_EQ(recent.dropped(), 1U);
    EXPECT_EQ(recent.repeated(), 2U);
}

TEST(RecentFrames, LatenciesAreTheNewestFrames) {
    RecentFrames recent;
    EXPECT_FALSE(recent.motion_to_photon_ms());
    FrameRecord frame = frame_of(5.0, 1);
    frame.pose = SampleInstants{};
    frame.warp = SampleInstants{.taken = HostTime(Nanoseconds(4'000'000)), .arrived = {}};
    frame.photon = HostTime(Nanoseconds(20'000'000));
    recent.add(frame);
    EXPECT_EQ(recent.motion_to_photon_ms(), 20.0);
    EXPECT_EQ(recent.warp_to_photon_ms(), 16.0);
    EXPECT_FALSE(recent.gaze_to_photon_ms());
}

}  // namespace
}  // namespace foverig
