#include "simulators/gaze/worsened_gaze.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulators/motion/eye_motion.h"
#include "tests/simulators/gaze/gaze_bench.h"

namespace foverig {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using test::at;

/// Sample frames of a tracker that was made worse, until then.
std::vector<test::GazeBench::Arrived> frames_of(const GazeWorsening& worsening, HostTime until) {
    test::GazeBench bench;
    WorsenedGaze worse(bench.device, bench.clock, worsening);
    EXPECT_TRUE(worse.control_set(gaze::request::start, 0, {}));
    std::vector<test::GazeBench::Arrived> frames;
    while (true) {
        const auto next = worse.next(until);
        const auto* packet = std::get_if<Packet>(&next);
        if (packet == nullptr) break;
        EXPECT_GE(bench.clock.now(), packet->arrival) << "nothing is told before it arrives";
        const auto frame = gaze::decode_frame(packet->bytes);
        EXPECT_TRUE(frame);
        if (const auto* sample = std::get_if<gaze::SampleFrame>(&*frame))
            frames.push_back({packet->arrival, *sample});
    }
    EXPECT_EQ(bench.clock.now(), until) << "a timeout is at the deadline";
    return frames;
}

dvec2 angles_deg(const gaze::Vec3f& on_the_wire) {
    return motion::gaze_of({-on_the_wire[0], on_the_wire[1], -on_the_wire[2]});
}

TEST(WorsenedGaze, BringsTheSameFramesLater) {
    const auto plain = frames_of({}, at(seconds(2)));
    const auto late = frames_of({.added_latency = milliseconds(40)}, at(seconds(2)));
    ASSERT_GT(plain.size(), 110U);
    ASSERT_EQ(late.size(), plain.size() - 3) << "of 60 Hz: exposed until 1.947 s instead of 1.987";
    for (std::size_t i = 0; i < late.size(); ++i) {
        EXPECT_EQ(late[i].at, plain[i].at + milliseconds(40));
        EXPECT_EQ(late[i].frame.exposure_ns, plain[i].frame.exposure_ns);
        EXPECT_EQ(late[i].frame.header.queued_ns, plain[i].frame.header.queued_ns + 40'000'000U)
            << "so that the clock map is none the worse";
        EXPECT_EQ(late[i].frame.left.direction, plain[i].frame.left.direction);
    }
}

TEST(WorsenedGaze, AddsNoiseOfTheStatedSizeToEachEye) {
    const auto plain = frames_of({}, at(seconds(60)));
    const auto noisy = frames_of({.added_noise_deg = 1.5, .seed = 7}, at(seconds(60)));
    ASSERT_EQ(noisy.size(), plain.size());
    double squares = 0.0;
    double left_by_right = 0.0;
    dvec2 sum(0.0);
    for (std::size_t i = 0; i < plain.size(); ++i) {
        const auto& before = plain[i].frame;
        const auto& after = noisy[i].frame;
        const dvec2 left = angles_deg(after.left.direction) - angles_deg(before.left.direction);
        const dvec2 right = angles_deg(after.right.direction) - angles_deg(before.right.direction);
        const dvec2 both = angles_deg(after.direction) - angles_deg(before.direction);
        squares += left.x * left.x + left.y * left.y;
        left_by_right += left.x * right.x;
        sum += left;
        EXPECT_NEAR(both.x, 0.5 * (left.x + right.x), 1e-3);
        EXPECT_EQ(noisy[i].at, plain[i].at);
    }
    const auto n = static_cast<double>(plain.size());
    EXPECT_NEAR(std::sqrt(squares / (2.0 * n)), 1.5, 0.05) << "3600 frames, two angles";
    EXPECT_NEAR(left_by_right / n / (1.5 * 1.5), 0.0, 0.06) << "eyes err independently";
    EXPECT_NEAR(sum.x / n, 0.0, 0.08);
}

TEST(WorsenedGaze, DrawsTheSameNoiseAgainAndOtherNoiseForAnotherSeed) {
    const auto once = frames_of({.added_noise_deg = 1.0, .seed = 1}, at(seconds(1)));
    const auto again = frames_of({.added_noise_deg = 1.0, .seed = 1}, at(seconds(1)));
    const auto other = frames_of({.added_noise_deg = 1.0, .seed = 2}, at(seconds(1)));
    EXPECT_EQ(once.back().frame.left.direction, again.back().frame.left.direction);
    EXPECT_NE(once.back().frame.left.direction, other.back().frame.left.direction);
}

}  // namespace
}  // namespace foverig
