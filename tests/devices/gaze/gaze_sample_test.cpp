#include "devices/gaze/gaze_sample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/devices/gaze/golden_sample.h"

namespace foverig {
namespace {

using test::golden_sample;

TEST(GazeSample, TurnsTheWiresFrameAboutY) {
    gaze::SampleFrame f = golden_sample();
    // Wire: left eye at x = +32 mm (x is left), looking 10 degrees to its left and ahead.
    const double angle = 10 * 3.14159265358979 / 180;
    f.left.direction = {static_cast<float>(std::sin(angle)), 0,
                        static_cast<float>(std::cos(angle))};
    const GazeSample s = to_sample(f);
    EXPECT_NEAR(s.left.ray.base_point_m.x, -0.032, 1e-9);
    EXPECT_NEAR(s.left.ray.base_point_m.z, 0.022, 1e-9);  // behind the lens plane
    EXPECT_NEAR(s.left.ray.direction.x, -std::sin(angle), 1e-7);
    EXPECT_NEAR(s.left.ray.direction.z, -std::cos(angle), 1e-7);
    EXPECT_EQ(s.right.ray.direction, dvec3(0, 0, -1));
    EXPECT_NEAR(s.right.pupil_radius_m, 0.002, 1e-9);
}

TEST(GazeSample, TheGoldenFrameIsValidStraightAhead) {
    const GazeSample s = to_sample(golden_sample());
    EXPECT_TRUE(s.valid && s.left.ray.valid && s.right.ray.valid && s.combined.valid);
    EXPECT_EQ(s.combined.direction, dvec3(0, 0, -1));
    EXPECT_EQ(s.device_time, GazeTime(Nanoseconds{1'000'000'000'000}));
    EXPECT_EQ(s.por_px, dvec2(480, 540));
    EXPECT_TRUE(std::isnan(s.vergence_distance_m));
}

TEST(GazeSample, TheValidityBitRules) {
    gaze::SampleFrame f = golden_sample();
    f.status &= static_cast<std::uint16_t>(~gaze::sample_status::left_valid);
    EXPECT_FALSE(to_sample(f).left.ray.valid);
    EXPECT_TRUE(to_sample(f).right.ray.valid);
    f = golden_sample();
    f.right.state = gaze::EyeState::visible;
    EXPECT_FALSE(to_sample(f).right.ray.valid);
}

TEST(GazeSample, NoDirectionThatIsNotOneIsBelieved) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const gaze::Vec3f bad[] = {{nan, nan, nan}, {0, 0, 0}, {0, 0, 1.5f}, {0, 0, -1}, {0, nan, 1}};
    for (const gaze::Vec3f& direction : bad) {
        gaze::SampleFrame f = golden_sample();
        f.left.direction = f.direction = direction;
        const GazeSample s = to_sample(f);
        EXPECT_FALSE(s.left.ray.valid);
        EXPECT_FALSE(s.combined.valid);
        EXPECT_EQ(s.left.ray.direction, dvec3(0, 0, -1));
    }
}

TEST(GazeSample, BlinkComesFromStatusOrCause) {
    gaze::SampleFrame f = golden_sample();
    f.status |= gaze::sample_status::right_blink;
    f.left.cause = gaze::EyeCause::blink;
    EXPECT_TRUE(to_sample(f).right.blink);
    EXPECT_TRUE(to_sample(f).left.blink);
    EXPECT_FALSE(to_sample(golden_sample()).left.blink);
}

}  // namespace
}  // namespace foverig
