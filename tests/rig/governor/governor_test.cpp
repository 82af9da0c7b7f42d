// The governor on machines that are functions: what a frame costs is known, so is the best setting.
#include "rig/governor/governor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace foverig::governor {
namespace {

const std::vector<double> kSetting_ms{4.0, 6.0, 9.0, 14.0, 20.0};
constexpr Limits kLimits{.limit_ms = 12.0, .patience_frames = 10};

struct Flight {
    int misses = 0;
    std::size_t last = 0;
    std::size_t changes = 0;
};

/// `load(frame)`: how much dearer frames are than where they were measured.
Flight fly(int frames, const std::function<double(int)>& load, double vsync_ms = 13.3) {
    Governor governor(kSetting_ms, kLimits);
    Flight flight;
    for (int i = 0; i < frames; ++i) {
        const double ms = kSetting_ms[governor.setting()] * load(i);
        flight.misses += ms > vsync_ms;
        governor.frame_took(ms);
    }
    flight.last = governor.setting();
    flight.changes = governor.changes();
    return flight;
}

TEST(Governor, StartsWithTheDearestThatFits) {
    EXPECT_EQ(Governor(kSetting_ms, kLimits).setting(), 2U);
    EXPECT_EQ(Governor({20.0, 30.0}, kLimits).setting(), 0U) << "nothing fits: the cheapest";
    EXPECT_EQ(Governor({1.0, 2.0}, kLimits).setting(), 1U);
}

TEST(Governor, StaysWhereItIsOnTheMachineThatMeasured) {
    const Flight flight = fly(1000, [](int) { return 1.0; });
    EXPECT_EQ(flight.changes, 0U);
    EXPECT_EQ(flight.last, 2U);
}

TEST(Governor, FindsTheDearestSettingThatAnotherMachineCanHold) {
    EXPECT_EQ(fly(1000, [](int) { return 0.5; }).last, 4U) << "twice as fast";
    EXPECT_EQ(fly(1000, [](int) { return 1.5; }).last, 1U);
    EXPECT_EQ(fly(1000, [](int) { return 2.5; }).last, 0U);
    const Flight slow = fly(1000, [](int) { return 2.5; });
    EXPECT_LE(slow.misses, 2);
}

TEST(Governor, GoesDownOverSeveralSettingsAtOnce) {
    Governor governor(kSetting_ms, kLimits);
    governor.frame_took(9.0 * 2.9);
    EXPECT_EQ(governor.setting(), 0U);
    EXPECT_EQ(governor.changes(), 1U);
}

TEST(Governor, HoldsAScenarioThatUnguardedWouldMissEveryOtherVsync) {
    const auto load = [](int i) { return i / 300 % 2 == 0 ? 0.8 : 1.6; };  // an expensive room
    int unguarded = 0;
    for (int i = 0; i < 6000; ++i) unguarded += 9.0 * load(i) > 13.3;
    EXPECT_GT(unguarded, 0.3 * 6000);
    EXPECT_LT(fly(6000, load).misses, 0.01 * 6000);
}

TEST(Governor, DoesNotSwingWhereASettingFitsButItsHistoryCosts) {
    // Every 23rd frame is half as dear again: the third setting fits between two of them.
    const auto load = [](int i) { return i % 23 == 22 ? 1.5 : 1.0; };
    const Flight flight = fly(4000, load);
    EXPECT_LT(flight.changes, 60U);
    EXPECT_LT(flight.misses, 40);
}

TEST(Governor, WaitsLongerAfterEachStepThatItHadToTakeBack) {
    Governor governor({4.0, 9.0}, kLimits);
    // The dearer setting is not what was measured: it never fits.
    std::vector<int> tries;
    for (int i = 0; i < 1000; ++i) {
        const std::size_t before = governor.setting();
        governor.frame_took(before == 0 ? 4.0 : 12.5);
        if (governor.setting() > before) tries.push_back(i);
    }
    ASSERT_GE(tries.size(), 4U);
    EXPECT_GT(tries[2] - tries[1], 1.8 * (tries[1] - tries[0]));
    EXPECT_LE(tries.size(), 16U) << "of 1000 frames, with a patience of ten";
}

TEST(Governor, DoesNotJudgeTheFirstFrameAfterAChange) {
    Governor governor(kSetting_ms, kLimits);
    governor.frame_took(13.0);
    EXPECT_EQ(governor.setting(), 1U);
    governor.frame_took(50.0);  // no history yet
    EXPECT_EQ(governor.setting(), 1U);
    governor.frame_took(50.0);
    EXPECT_EQ(governor.setting(), 0U);
}

}  // namespace
}  // namespace foverig::governor
