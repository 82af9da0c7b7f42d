#include "rig/records/vsync_count.h"

#include <gtest/gtest.h>

namespace foverig {
namespace {

constexpr Nanoseconds kPeriod{13'333'333};

FrameRecord shown(std::uint64_t aimed, std::uint64_t at) {
    FrameRecord f;
    f.aimed_vsync = HostTime(kPeriod * static_cast<std::int64_t>(aimed));
    f.vsync = HostTime(kPeriod * static_cast<std::int64_t>(at));
    f.shown_vsync = at;
    return f;
}

FrameRecord dropped(std::uint64_t aimed) {
    FrameRecord f = shown(aimed, aimed);
    f.drop();
    return f;
}

TEST(VsyncCount, TellsMissesRepeatsAndDropsApart) {
    // VSyncs 10 11 12 13 14 15: frames at 10, 11, 14 and 15; the one aimed at 14 came before its
    // successor and was replaced.
    const VsyncCount c =
        count_vsyncs({shown(10, 10), shown(11, 11), shown(12, 14), dropped(15), shown(15, 15)});
    EXPECT_EQ(c.rendered, 5U);
    EXPECT_EQ(c.presented, 4U);
    EXPECT_EQ(c.dropped, 1U);
    EXPECT_EQ(c.late, 2U);
    EXPECT_EQ(c.total, 6U);
    EXPECT_EQ(c.missed, 2U);
    EXPECT_EQ(c.total, c.presented + c.missed);
    EXPECT_EQ(c.rendered, c.presented + c.dropped);
}

TEST(VsyncCount, TellsMisPresentedFramesFromLateOnes) {
    FrameRecord foreseen = shown(12, 14);  // late, but its pose was predicted for 14
    FrameRecord early = shown(15, 15);
    early.mis_presented = true;
    FrameRecord replaced = early;
    replaced.drop();
    const VsyncCount c = count_vsyncs({shown(10, 10), foreseen, early, replaced});
    EXPECT_EQ(c.late, 2U) << "what was dropped is late too";
    EXPECT_EQ(c.mis_presented, 1U);
}

TEST(VsyncCount, CountsNothingWhereNothingWasShown) {
    EXPECT_EQ(count_vsyncs({}).total, 0U);
    const VsyncCount c = count_vsyncs({dropped(3)});
    EXPECT_EQ(c.total, 0U);
    EXPECT_EQ(c.missed, 0U);
    EXPECT_EQ(c.dropped, 1U);
}

}  // namespace
}  // namespace foverig
