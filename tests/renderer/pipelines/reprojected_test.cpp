// `reprojected` against `full`: the fovea to the bit, the rest nearby.
#include <gtest/gtest.h>

#include "tests/renderer/pipelines/reprojected_flight.h"

namespace foverig {
namespace {

void expect_fovea_equals_full(const char* scene_name, const RenderSettings& settings, int frames) {
    const auto scene = builtin(scene_name);
    const auto reprojected = make_renderer(scene, settings);
    const auto full = make_renderer(scene, as_full(settings));
    for (int frame = 0; frame < frames; ++frame) {
        const FrameInput input = input_at(*scene, frame);
        const FrameStats stats = reprojected->render(input);
        full->render(input);
        const Difference d = within(reprojected->image(0), full->image(0), input.eyes[0],
                                    settings.foveation.r0_deg - 0.001);
        ASSERT_GT(d.compared, 1000);
        ASSERT_EQ(d.different, 0) << "frame " << frame << ": " << d.different << " of "
                                  << d.compared << " by up to " << d.worst;
        ASSERT_EQ(stats.numerics.nan + stats.numerics.inf, 0U);
    }
}

TEST(Reprojected, TheFoveaEqualsFullToTheBitWithAPointLight) {
    expect_fovea_equals_full("cornell", only_point_light(), 5);
}
TEST(Reprojected, TheFoveaEqualsFullToTheBitWithNoisyLight) {
    expect_fovea_equals_full("cornell", all_light(), 5);
}
TEST(Reprojected, TheFoveaEqualsFullToTheBitAmongTexturesAndMasks) {
    expect_fovea_equals_full("atrium", all_light(), 4);
}

TEST(Reprojected, FullProbabilityEverywhereIsTheFullRenderer) {
    RenderSettings settings = all_light();
    settings.foveation = {180.0, 180.0, 1.0};
    const auto scene = builtin("atrium");
    const auto reprojected = make_renderer(scene, settings);
    const auto full = make_renderer(scene, as_full(settings));
    for (int frame = 0; frame < 3; ++frame) {
        const FrameInput input = input_at(*scene, frame);
        const FrameStats stats = reprojected->render(input);
        full->render(input);
        EXPECT_EQ(stats.sampled_pixels, stats.all_pixels);
        ASSERT_TRUE(reprojected->image(0).pixels == full->image(0).pixels) << frame;
    }
}

TEST(Reprojected, AStillEyeConvergesTowardsTheFullImage) {
    const auto scene = builtin("atrium");
    const auto reprojected = make_renderer(scene, only_point_light());
    const auto full = make_renderer(scene, as_full(only_point_light()));
    full->render(input_at(*scene, 0, true));
    const Image truth = full->image(0);
    reprojected->render(input_at(*scene, 0, true));
    const double first = mean_absolute_error(reprojected->image(0), truth);
    for (int frame = 1; frame < 40; ++frame) reprojected->render(input_at(*scene, frame, true));
    const double last = mean_absolute_error(reprojected->image(0), truth);
    EXPECT_LT(last, 0.5 * first) << "from " << first << " to " << last;
    EXPECT_LT(last, 0.012);
}

TEST(Reprojected, AMovingEyeStaysNearTheFullImage) {
    const auto scene = builtin("atrium");
    const auto reprojected = make_renderer(scene, only_point_light());
    const auto full = make_renderer(scene, as_full(only_point_light()));
    for (int frame = 0; frame < 20; ++frame) reprojected->render(input_at(*scene, frame));
    full->render(input_at(*scene, 19));
    EXPECT_LT(mean_absolute_error(reprojected->image(0), full->image(0)), 0.03);
}

TEST(Reprojected, TakesANewResolutionInItsStride) {
    const auto scene = builtin("cornell");
    const auto reprojected = make_renderer(scene, all_light());
    const auto full = make_renderer(scene, as_full(all_light()));
    const std::pair<int, int> sizes[] = {{320, 396}, {320, 396}, {161, 203}, {161, 203},
                                         {400, 130}, {320, 396}, {65, 64}};
    int frame = 0;
    for (const auto& [width, height] : sizes) {
        const FrameInput input = input_at(*scene, frame++, false, width, height);
        const FrameStats stats = reprojected->render(input);
        full->render(input);
        const Image image = reprojected->image(0);
        ASSERT_EQ(image.width_px, width);
        ASSERT_EQ(image.height_px, height);
        EXPECT_EQ(stats.numerics.nan + stats.numerics.inf, 0U);
        for (const vec3& p : image.pixels) ASSERT_TRUE(std::isfinite(p.x + p.y + p.z));
        EXPECT_EQ(within(image, full->image(0), input.eyes[0], 9.99).different, 0) << width;
        EXPECT_LT(mean_absolute_error(image, full->image(0)), 0.12) << width;
    }
}

TEST(Reprojected, ATeleportLeavesNoGhostInTheFoveaAndNoNan) {
    const auto scene = builtin("cornell");
    const auto reprojected = make_renderer(scene, all_light());
    const auto full = make_renderer(scene, as_full(all_light()));
    for (int frame = 0; frame < 6; ++frame) {
        FrameInput input = input_at(*scene, frame);
        EyeView& view = input.eyes[0].view;
        if (frame == 2)
            view.world_from_eye =
                view.world_from_eye * mat3(-1, 0, 0, 0, 1, 0, 0, 0, -1);  // about face
        if (frame == 3) view.position_m += vec3(1000.0F, 0.0F, 0.0F);     // out into the void
        if (frame == 4) view.position_m = {1.0F, 0.5F, 2.0F};
        const FrameStats stats = reprojected->render(input);
        full->render(input);
        EXPECT_EQ(stats.numerics.nan + stats.numerics.inf, 0U) << frame;
        EXPECT_EQ(within(reprojected->image(0), full->image(0), input.eyes[0], 9.99).different, 0)
            << frame;
        for (const vec3& p : reprojected->image(0).pixels)
            ASSERT_TRUE(std::isfinite(p.x + p.y + p.z));
    }
}

}  // namespace
}  // namespace foverig
