#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "renderer/foveation/foveal_function.h"
#include "renderer/kernels/camera_rays.h"
#include "renderer/scene/library.h"
#include "tests/renderer/small_scenes.h"

namespace foverig {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 396;
constexpr double kRate_hz = 75.0;

std::shared_ptr<const Scene> builtin(const char* name) {
    static std::map<std::string, std::shared_ptr<const Scene>> made;
    auto& scene = made[name];
    if (scene == nullptr) scene = std::make_shared<const Scene>(make_builtin_scene(name, 0.5));
    return scene;
}

/// A head that drifts and turns around the scene's first camera key.
EyeView moving_view(const Scene& scene, int frame, int width_px = kWidth, int height_px = kHeight) {
    const CameraKey& key = scene.camera_path[0];
    const float t = static_cast<float>(frame) * 0.02F;
    return view_at(key.position_m + vec3(0.3F * std::sin(t), 0.1F * t, -0.2F * t),
                   key.target_m + vec3(0.5F * std::sin(2.0F * t), 0.0F, 0.0F), width_px, height_px,
                   1.08F);
}

FrameInput input_at(const Scene& scene, int frame, bool still = false, int width_px = kWidth,
                    int height_px = kHeight) {
    FrameInput input = frame_of(moving_view(scene, still ? 0 : frame, width_px, height_px),
                                static_cast<std::uint32_t>(frame));
    input.time_s = still ? 0.0 : frame / kRate_hz;
    input.eyes[0].gaze = glm::normalize(
        vec3(0.1F * std::cos(0.3F * static_cast<float>(still ? 0 : frame)), -0.08F, -1.0F));
    return input;
}

RenderSettings only_point_light() {
    RenderSettings s = settings_of("reprojected");
    s.lighting.area_lights = false;
    return s;
}

RenderSettings all_light() {
    RenderSettings s = settings_of("reprojected");
    s.lighting.area_samples = 4;
    s.lighting.ao_samples = 2;
    s.lighting.ao_radius_m = 1.0;
    return s;
}

RenderSettings as_full(RenderSettings s) {
    s.pipeline = "full";
    return s;
}

struct Difference {
    int compared = 0;
    int different = 0;
    double worst = 0.0;
};

/// Over the pixels whose centres lie within `radius_deg` of the gaze.
Difference within(const Image& a, const Image& b, const EyeInput& eye, double radius_deg) {
    Difference d;
    const EyeRays rays(eye.view);
    const dvec3 gaze = dmat3(eye.view.world_from_eye) * dvec3(eye.gaze);
    for (int y = 0; y < a.height_px; ++y) {
        for (int x = 0; x < a.width_px; ++x) {
            if (glm::degrees(angle_between_rad(dvec3(rays.direction(static_cast<float>(x) + 0.5F,
                                                                    static_cast<float>(y) + 0.5F)),
                                               gaze)) > radius_deg)
                continue;
            ++d.compared;
            if (a.at(x, y) == b.at(x, y)) continue;
            ++d.different;
            for (int c = 0; c < 3; ++c)
                d.worst =
                    std::max(d.worst, std::abs(static_cast<double>(a.at(x, y)[c] - b.at(x, y)[c])));
        }
    }
    return d;
}

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
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const double e_deg = glm::degrees(angle_between_rad(
                dvec3(rays.direction(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F)),
                gaze));
            const double foveal = std::clamp(1.0 - 0.95 * (e_deg - 10.0) / 10.0, 0.05, 1.0);
            const double p = on_grid(x, 69, kWidth) && on_grid(y, 86, kHeight) ? 1.0 : foveal;
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
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                if (glm::degrees(
                        angle_between_rad(dvec3(rays.direction(static_cast<float>(x) + 0.5F,
                                                               static_cast<float>(y) + 0.5F)),
                                          gaze)) > 9.99)
                    continue;
                ASSERT_EQ(mask.pixels[static_cast<std::size_t>(y * kWidth + x)], 1);
            }
        }
        EXPECT_EQ(mask.pixels[0], 1) << "the corner belongs to the support image";
    }
}

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
        EXPECT_EQ(stats.all_pixels, 2U * kWidth * kHeight);
        right_alone->render(one);
    }
    EXPECT_TRUE(both->image(1).pixels == right_alone->image(0).pixels);
    EXPECT_FALSE(both->image(0).pixels == both->image(1).pixels);
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
