#include "devices/display/latency_tester.h"

#include <gtest/gtest.h>

namespace foverig {
namespace {

constexpr Nanoseconds kMs{1'000'000};
constexpr Nanoseconds kFrame{13'333'333};

HostTime vsync(int n) {
    return HostTime(n * kFrame);
}

/// Frame n is submitted 3 ms before vsync n + 1, with a pose 10 ms old, predicted 1 ms too early.
LatencyMark mark(int n) {
    return {.frame_id = static_cast<std::uint64_t>(n),
            .imu_sample = vsync(n + 1) - 13 * kMs,
            .submit = vsync(n + 1) - 3 * kMs,
            .predicted_scan_out = vsync(n + 1) - kMs};
}

std::uint16_t count(int n) {
    return static_cast<std::uint16_t>(65530 + n);
}

/// The panel is idle at vsync n.
void see_idle(LatencyTester& tester, int n) {
    EXPECT_TRUE(tester.read_back(count(n), vsync(n), grey_of_level(kIdleLevel)).empty());
}

TEST(LatencyTester, PaletteIsLibOvrs) {
    const int greys[] = {16, 48, 80, 112, 144, 176, 208, 240};
    for (int i = 0; i < 8; ++i) {
        EXPECT_EQ(grey_of_level(i), greys[i]);
        for (int off = -9; off <= 9; ++off)
            EXPECT_EQ(level_of_grey(static_cast<std::uint8_t>(greys[i] + off)), i);
    }
    EXPECT_FALSE(level_of_grey(0));
    EXPECT_FALSE(level_of_grey(58));
    EXPECT_FALSE(level_of_grey(255));
}

TEST(LatencyTester, ColoursAreNeverIdleAndRepeatAfterSeven) {
    LatencyTester tester;
    std::uint8_t first = 0;
    for (int n = 0; n < 15; ++n) {
        const std::uint8_t grey = tester.mark(mark(n));
        if (n == 0) first = grey;
        EXPECT_NE(level_of_grey(grey), kIdleLevel);
        EXPECT_EQ(grey == first, n % 7 == 0);
    }
}

TEST(LatencyTester, MeasuresEachFrameThroughADelayedReadback) {
    LatencyTester tester;
    see_idle(tester, 0);
    std::uint8_t grey_of[40];
    std::vector<LatencyReading> all;
    for (int n = 0; n < 40; ++n) {
        grey_of[n] = tester.mark(mark(n));
        // At vsync n + 2 the answer for frame n - 1 (scanned out at vsync n) is there, off by some
        // grey.
        if (n == 0) continue;
        const auto grey = static_cast<std::uint8_t>(grey_of[n - 1] + (n % 2 ? 7 : -8));
        const auto readings = tester.read_back(count(n), vsync(n), grey);
        all.insert(all.end(), readings.begin(), readings.end());
    }
    ASSERT_EQ(all.size(), 39u);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i].frame_id, i);
        EXPECT_EQ(all[i].motion_to_scan_out, 13 * kMs);
        EXPECT_EQ(all[i].submit_to_scan_out, 3 * kMs);
        EXPECT_EQ(all[i].prediction_error, kMs);
    }
    EXPECT_EQ(tester.post_present(), 3 * kMs);
}

TEST(LatencyTester, ARepeatedFrameCountsItsFirstScanOutOnly) {
    LatencyTester tester;
    see_idle(tester, 0);
    const std::uint8_t a = tester.mark(mark(0));
    EXPECT_TRUE(tester.read_back(count(1), vsync(1), a).empty());
    EXPECT_EQ(tester.read_back(count(2), vsync(2), a).size(), 1u);
    EXPECT_TRUE(tester.read_back(count(3), vsync(3), a).empty());
    const std::uint8_t b = tester.mark(mark(3));
    const auto readings = tester.read_back(count(4), vsync(4), b);
    ASSERT_EQ(readings.size(), 1u);
    EXPECT_EQ(readings[0].frame_id, 3u);
}

TEST(LatencyTester, ALostReadCostsReadingsButIsNeverWrong) {
    LatencyTester tester;
    see_idle(tester, 0);
    std::vector<LatencyReading> all;
    for (int n = 0; n < 20; ++n) {
        const std::uint8_t grey = tester.mark(mark(n));
        if (n == 10) continue;
        for (const LatencyReading& r : tester.read_back(count(n + 1), vsync(n + 1), grey))
            all.push_back(r);
    }
    EXPECT_EQ(all.size(), 18u);  // neither the lost one nor the one after it
    for (const LatencyReading& r : all) EXPECT_EQ(r.motion_to_scan_out, 13 * kMs);
}

// Frame 2 stays for two vsyncs, its first read is lost or unreadable: its second scan-out must not
// pass for its first.
TEST(LatencyTester, ASecondScanOutIsNotTakenForALostFirst) {
    for (const bool lost : {true, false}) {
        LatencyTester tester;
        see_idle(tester, 0);
        std::vector<std::uint64_t> frames;
        const auto read = [&](int n, std::uint8_t grey) {
            for (const LatencyReading& r : tester.read_back(count(n), vsync(n), grey)) {
                EXPECT_EQ(r.motion_to_scan_out, 13 * kMs);
                frames.push_back(r.frame_id);
            }
        };
        read(1, tester.mark(mark(0)));
        read(2, tester.mark(mark(1)));
        const std::uint8_t stays = tester.mark(mark(2));
        if (!lost) read(3, 228);  // between two levels
        read(4, stays);
        read(5, tester.mark(mark(4)));
        EXPECT_EQ(frames, (std::vector<std::uint64_t>{0, 1, 4}));
    }
}

TEST(LatencyTester, ALoneMatchIsNotBelieved) {
    LatencyTester tester;
    const std::uint8_t grey = tester.mark(mark(0));
    EXPECT_TRUE(tester.read_back(count(1), vsync(1), grey).empty());
    EXPECT_TRUE(tester.read_back(count(2), vsync(2), 16).empty());   // idle
    EXPECT_TRUE(tester.read_back(count(3), vsync(3), 230).empty());  // between two levels
    EXPECT_FALSE(tester.post_present());
}

TEST(LatencyTester, FramesTooOldForTheirColourAreForgotten) {
    LatencyTester tester;
    const std::uint8_t grey = tester.mark(mark(0));
    EXPECT_TRUE(tester.read_back(count(20), vsync(20), grey).empty());
    EXPECT_TRUE(tester.read_back(count(21), vsync(21), grey).empty());
}

}  // namespace
}  // namespace foverig
