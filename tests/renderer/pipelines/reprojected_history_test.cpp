// What `reprojected` carries from frame to frame, and that threads do not touch it.
#include <gtest/gtest.h>

#include "tests/renderer/pipelines/reprojected_flight.h"

namespace foverig {
namespace {

std::vector<vec3> run_frames(const RenderSettings& settings, int frames) {
    const auto scene = builtin("cornell");
    const auto renderer = make_renderer(scene, settings);
    std::vector<vec3> all;
    for (int frame = 0; frame < frames; ++frame) {
        renderer->render(input_at(*scene, frame));
        const Image image = renderer->image(0);
        all.insert(all.end(), image.pixels.begin(), image.pixels.end());
    }
    return all;
}

TEST(Reprojected, RunsRepeatToTheBitOnAnyNumberOfThreads) {
    RenderSettings settings = all_light();
    const std::vector<vec3> two = run_frames(settings, 4);
    EXPECT_TRUE(two == run_frames(settings, 4));
    settings.threads = 1;
    EXPECT_TRUE(two == run_frames(settings, 4));
    settings.threads = 3;
    EXPECT_TRUE(two == run_frames(settings, 4));
    settings.seed = 2;
    EXPECT_FALSE(two == run_frames(settings, 4));
}

TEST(Reprojected, AJumpInTheFrameNumberKeepsTheHistory) {
    const auto scene = builtin("cornell");
    const auto renderer = make_renderer(scene, only_point_light());
    for (int frame = 0; frame < 10; ++frame) renderer->render(input_at(*scene, frame, true));
    FrameInput input = input_at(*scene, 10, true);
    input.frame = 70000;  // past the wrap of the 16-bit age
    renderer->render(input);
    const auto full = make_renderer(scene, as_full(only_point_light()));
    full->render(input);
    EXPECT_LT(mean_absolute_error(renderer->image(0), full->image(0)), 0.02);
}

TEST(Reprojected, TwoEyesAreRenderedEachFromItsOwnHistory) {
    const auto scene = builtin("cornell");
    const auto both = make_renderer(scene, only_point_light());
    const auto right_alone = make_renderer(scene, only_point_light());
    for (int frame = 0; frame < 3; ++frame) {
        FrameInput one = input_at(*scene, frame);
        FrameInput two = one;
        two.eyes.insert(two.eyes.begin(), two.eyes[0]);
        two.eyes[0].view.position_m.x -= 0.064F;
        const FrameStats stats = both->render(two);
        EXPECT_EQ(stats.all_pixels, 2U * kFlightWidth * kFlightHeight);
        right_alone->render(one);
    }
    EXPECT_TRUE(both->image(1).pixels == right_alone->image(0).pixels);
    EXPECT_FALSE(both->image(0).pixels == both->image(1).pixels);
}

}  // namespace
}  // namespace foverig
