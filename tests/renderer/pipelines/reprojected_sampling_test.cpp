// Which pixels `reprojected` traces, and where in them.
#include <gtest/gtest.h>

#include "tests/renderer/pipelines/reprojected_flight.h"

namespace foverig {
namespace {

TEST(Reprojected, WithNothingToResampleItSamplesByTheFovealFunctionAndTheSupportImage) {
    const auto scene = builtin("atrium");
    RenderSettings settings = only_point_light();
    settings.reprojection.epsilon_depth = 1.0e30;
    settings.reprojection.epsilon_lum = 2.0;
    settings.reprojection.epsilon_grazing = 0.0;
    const auto renderer = make_renderer(scene, settings);
    renderer->render(input_at(*scene, 0, true));
    const FrameInput input = input_at(*scene, 1, true);
    const FrameStats stats = renderer->render(input);
    const EyeRays rays(input.eyes[0].view);
    const dvec3 gaze = dmat3(input.eyes[0].view.world_from_eye) * dvec3(input.eyes[0].gaze);
    const auto on_grid = [](int at, int count, int size) {
        const double step = (size - 1.0) / (count - 1);
        return std::round(std::round(at / step) * step) == at;
    };
    double expected = 0.0;
    double variance = 0.0;
    for (int y = 0; y < kFlightHeight; ++y) {
        for (int x = 0; x < kFlightWidth; ++x) {
            const double e_deg = glm::degrees(angle_between_rad(
                dvec3(rays.direction(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F)),
                gaze));
            const double foveal = std::clamp(1.0 - 0.95 * (e_deg - 10.0) / 10.0, 0.05, 1.0);
            const double p =
                on_grid(x, 69, kFlightWidth) && on_grid(y, 86, kFlightHeight) ? 1.0 : foveal;
            expected += p;
            variance += p * (1.0 - p);
        }
    }
    EXPECT_NEAR(static_cast<double>(stats.sampled_pixels), expected, 5.0 * std::sqrt(variance));
}

TEST(Reprojected, SamplesAMinorityOfPixelsButAtLeastTheSupportImage) {
    const auto scene = builtin("atrium");
    const auto renderer = make_renderer(scene, only_point_light());
    for (int frame = 0; frame < 4; ++frame) {
        const FrameStats stats = renderer->render(input_at(*scene, frame, false, 1182, 1464));
        const double ratio =
            static_cast<double>(stats.sampled_pixels) / static_cast<double>(stats.all_pixels);
        EXPECT_EQ(stats.rays.primary, stats.sampled_pixels);
        EXPECT_GT(ratio, 256.0 * 318.0 / (1182.0 * 1464.0)) << frame;
        EXPECT_LT(ratio, 0.4) << frame;
    }
}

TEST(Reprojected, TheSamplingMaskShowsWhatWasTracedAndTheFoveaWholly) {
    const auto scene = builtin("cornell");
    const auto renderer = make_renderer(scene, only_point_light());
    for (int frame = 0; frame < 3; ++frame) {
        const FrameInput input = input_at(*scene, frame);
        const FrameStats stats = renderer->render(input);
        const Mask mask = renderer->sampling_mask(0);
        EXPECT_EQ(static_cast<std::uint64_t>(
                      std::count(mask.pixels.begin(), mask.pixels.end(), std::uint8_t{1})),
                  stats.sampled_pixels);
        const EyeRays rays(input.eyes[0].view);
        const dvec3 gaze = dmat3(input.eyes[0].view.world_from_eye) * dvec3(input.eyes[0].gaze);
        for (int y = 0; y < kFlightHeight; ++y) {
            for (int x = 0; x < kFlightWidth; ++x) {
                if (glm::degrees(
                        angle_between_rad(dvec3(rays.direction(static_cast<float>(x) + 0.5F,
                                                               static_cast<float>(y) + 0.5F)),
                                          gaze)) > 9.99)
                    continue;
                ASSERT_EQ(mask.pixels[static_cast<std::size_t>(y * kFlightWidth + x)], 1);
            }
        }
        EXPECT_EQ(mask.pixels[0], 1) << "the corner belongs to the support image";
    }
}

TEST(Reprojected, OversamplingSmoothsEdgesOfAStillImage) {
    // A slanted edge between two paints of one plane: with jitter accumulated its pixels take
    // values in between.
    SmallScene s;
    s.add_quad(s.add_matte(vec3(1.0F)), {-0.1F, -4, -2}, {8, 0, 0}, {0.8F, 8, 0});
    s.add_quad(s.add_matte(vec3(0.0F)), {-0.1F, -4, -2}, {0.8F, 8, 0}, {-8, 0, 0});
    s.scene().ambient = vec3(1.0F);
    const auto scene = s.finish();
    const auto between = [&](bool oversampling) {
        RenderSettings settings = only_point_light();
        settings.reprojection.oversampling = oversampling;
        const auto renderer = make_renderer(scene, settings);
        for (std::uint32_t frame = 0; frame < 30; ++frame)
            renderer->render(frame_of(view_at({0.3F, 0, 0}, {0.3F, 0, -1}, 128, 128), frame));
        int n = 0;
        const Image image = renderer->image(0);
        for (int y = 54; y < 74;
             ++y)  // within r0 of the middle: elsewhere reprojection blurs anyway
            for (int x = 54; x < 74; ++x)
                n += image.at(x, y).x > 0.05F && image.at(x, y).x < 0.95F ? 1 : 0;
        return n;
    };
    EXPECT_EQ(between(false), 0);
    EXPECT_GT(between(true), 10);
}

TEST(Reprojected, AWrongFootprintIsRefusedByName) {
    RenderSettings settings = only_point_light();
    settings.reprojection.footprint_samples = 3;
    EXPECT_THROW(make_renderer(builtin("cornell"), settings), std::invalid_argument);
}

}  // namespace
}  // namespace foverig
