#include "devices/gaze/gaze_filter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/devices/byte_text.h"

namespace foverig {
namespace {

constexpr double kRadians = 3.14159265358979323846 / 180;

HostTime at_ms(double ms) {
    return HostTime(from_seconds(ms * 1e-3));
}

dvec3 to_the_right(double deg) {
    return {std::sin(deg * kRadians), 0, -std::cos(deg * kRadians)};
}
double degrees_right(const dvec3& d) {
    return std::atan2(d.x, -d.z) / kRadians;
}

GazeSample looking(double ms, double deg) {
    GazeSample s;
    s.host_time = at_ms(ms);
    s.left.ray = s.right.ray = s.combined = {.valid = true, .direction = to_the_right(deg)};
    s.left.confidence = s.right.confidence = 1;
    return s;
}

TEST(GazeFilter, NothingSeenIsStraightAheadAndNotUsable) {
    const FilteredGaze g = GazeFilter{}.at(at_ms(5));
    EXPECT_FALSE(g.left.usable);
    EXPECT_TRUE(g.left.held);
    EXPECT_EQ(g.left.direction, dvec3(0, 0, -1));
}

TEST(GazeFilter, AgeIsTimeSinceExposure) {
    GazeFilter filter;
    filter.add(looking(100, 3));
    const FilteredEye eye = filter.at(at_ms(137)).left;
    EXPECT_EQ(eye.age, Nanoseconds{37'000'000});
    EXPECT_TRUE(eye.usable);
    EXPECT_NEAR(degrees_right(eye.direction), 3, 1e-9);
}

TEST(GazeFilter, ASaccadePassesAtOnce) {
    GazeFilter filter;
    for (int i = 0; i < 30; ++i) filter.add(looking(16.7 * i, 0));
    filter.add(looking(16.7 * 30, 8));
    EXPECT_TRUE(filter.at(at_ms(520)).left.saccade);
    EXPECT_NEAR(degrees_right(filter.at(at_ms(520)).left.direction), 8, 1e-9);
    filter.add(looking(16.7 * 31, 10));
    filter.add(looking(16.7 * 32, 10.1));
    // The first slow sample after it starts the fixation where the eye landed.
    EXPECT_FALSE(filter.at(at_ms(540)).left.saccade);
    EXPECT_NEAR(degrees_right(filter.at(at_ms(540)).left.direction), 10.1, 1e-9);
}

TEST(GazeFilter, AFixationIsAOnePoleLowPass) {
    GazeFilter filter;
    filter.add(looking(0, 0));
    filter.add(looking(20, 0.5));  // 25 deg/s: no saccade
    EXPECT_NEAR(degrees_right(filter.at(at_ms(20)).left.direction),
                0.5 * (1 - std::exp(-20.0 / 30.0)), 1e-4);
}

TEST(GazeFilter, SmoothingLessensTrackerNoise) {
    GazeFilter filter;
    test::Random random(4);
    double raw = 0, smooth = 0;
    for (int i = 0; i < 2000; ++i) {
        const double deg = 0.4 * (random.uniform() - 0.5);  // std 0.115 degrees
        filter.add(looking(16.7 * i, deg));
        raw += deg * deg;
        smooth += std::pow(degrees_right(filter.at(at_ms(16.7 * i)).left.direction), 2);
    }
    EXPECT_LT(std::sqrt(smooth / raw), 0.75);
}

TEST(GazeFilter, HoldsThroughABlinkAndSaysSo) {
    GazeFilter filter;
    filter.add(looking(0, 5));
    GazeSample lid = looking(17, -3);  // the pupil droops before the lid closes
    lid.left.confidence = lid.right.confidence = 0.5;
    filter.add(lid);
    GazeSample shut = looking(34, -8);
    shut.left.blink = shut.right.blink = true;
    filter.add(shut);
    const FilteredGaze g = filter.at(at_ms(50));
    EXPECT_TRUE(g.left.held && g.right.held && g.combined.held);
    EXPECT_NEAR(degrees_right(g.left.direction), 5, 1e-9);
    EXPECT_EQ(g.left.age, Nanoseconds{50'000'000});
    EXPECT_FALSE(filter.at(at_ms(501)).left.usable);
    filter.add(looking(200, 9));
    EXPECT_FALSE(filter.at(at_ms(210)).left.held);
    EXPECT_NEAR(degrees_right(filter.at(at_ms(210)).left.direction), 9, 1e-9);
}

TEST(GazeFilter, AnEyeWithoutARayFollowsTheOther) {
    GazeFilter filter;
    GazeSample s = looking(0, 6);
    s.left.ray = {};
    filter.add(s);
    EXPECT_NEAR(degrees_right(filter.at(at_ms(1)).left.direction), 6, 1e-9);
    EXPECT_TRUE(filter.at(at_ms(1)).left.usable);
}

TEST(GazeFilter, ZeroTimeConstantPassesThrough) {
    GazeFilter filter({.fixation_time_constant_s = 0});
    filter.add(looking(0, 0));
    filter.add(looking(20, 0.4));
    EXPECT_NEAR(degrees_right(filter.at(at_ms(20)).left.direction), 0.4, 1e-12);
}

TEST(GazeFilter, SamplesOutOfOrderAreIgnored) {
    GazeFilter filter;
    filter.add(looking(20, 1));
    filter.add(looking(20, 50));
    filter.add(looking(10, 50));
    EXPECT_NEAR(degrees_right(filter.at(at_ms(20)).left.direction), 1, 1e-9);
}

}  // namespace
}  // namespace foverig
