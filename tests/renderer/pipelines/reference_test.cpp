#include "renderer/pipelines/reference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/scene/library.h"
#include "tests/renderer/small_scenes.h"

namespace foverig {
namespace {

RenderSettings reference(int samples, int max_bounces) {
    RenderSettings s = settings_of("reference");
    s.reference.samples = samples;
    s.reference.max_bounces = max_bounces;
    return s;
}

/// Renders until nothing is added any more.
FrameStats finish(Renderer& renderer, const FrameInput& input) {
    FrameStats last = renderer.render(input);
    for (FrameStats next = last; next.rays.primary > 0; next = renderer.render(input)) last = next;
    return last;
}

Image converged(const std::shared_ptr<const Scene>& scene, const RenderSettings& settings,
                const EyeView& view) {
    const auto renderer = make_renderer(scene, settings);
    finish(*renderer, frame_of(view));
    return renderer->image(0);
}

dvec3 mean(const Image& image) {
    dvec3 sum(0.0);
    for (const vec3& p : image.pixels) sum += dvec3(p);
    return sum / static_cast<double>(image.pixels.size());
}

/// An empty box around the origin with matte walls of one paint.
std::shared_ptr<const Scene> furnace(float paint, float ambient) {
    SmallScene s;
    const std::uint16_t m = s.add_matte(vec3(paint));
    for (const float z : {-2.0F, 2.0F}) s.add_quad(m, {-2, -2, z}, {4, 0, 0}, {0, 4, 0});
    for (const float y : {-2.0F, 2.0F}) s.add_quad(m, {-2, y, -2}, {4, 0, 0}, {0, 0, 4});
    for (const float x : {-2.0F, 2.0F}) s.add_quad(m, {x, -2, -2}, {0, 4, 0}, {0, 0, 4});
    s.scene().ambient = vec3(ambient);
    return s.finish();
}

TEST(Reference, AClosedBoxIsTheGeometricSeriesOfItsBounces) {
    // Every vertex gets rho a, every bounce weighs rho: L = a rho (1 - rho^(B+1)) / (1 - rho),
    // without noise.
    for (const int bounces : {0, 1, 2, 5}) {
        const Image image = converged(furnace(0.6F, 0.5F), reference(8, bounces),
                                      view_at({0, 0, 0}, {1, 0.2F, -1}, 70, 66));
        const double expected = 0.5 * 0.6 * (1.0 - std::pow(0.6, bounces + 1)) / 0.4;
        for (const vec3& p : image.pixels) ASSERT_NEAR(p.x, expected, 1.0e-5) << bounces;
    }
}

TEST(Reference, OneBounceOfAWallOntoTheFloorIsItsFormFactor) {
    // An endless strip of wall of height h, paint 0.5, beside a floor of paint 0.8, ambient a
    // everywhere: floor = 0.8 a (1 + 0.5 F), F = (1 - d / sqrt(d^2 + h^2)) / 2.
    SmallScene s;
    s.add_quad(s.add_matte(vec3(0.8F)), {0, 0, 4000}, {20, 0, 0}, {0, 0, -8000});
    s.add_quad(s.add_matte(vec3(0.5F)), {0, 0, 4000}, {0, 0, -8000}, {0, 1.5F, 0});
    s.scene().ambient = vec3(1.0F);
    const EyeView view = view_at({2, 2, 0}, {2, 0, 0}, 48, 48, 0.5F);
    const Image image = converged(s.finish(), reference(128, 1), view);
    for (int y = 0; y < 48; y += 8) {
        for (int x = 0; x < 48; x += 8) {
            double seen = 0.0;
            double expected = 0.0;
            for (int i = 0; i < 64; ++i) {
                const double d = floor_point(view, x + i % 8, y + i / 8).x;
                seen += static_cast<double>(image.at(x + i % 8, y + i / 8).x) / 64;
                expected += 0.8 * (1.0 + 0.25 * (1.0 - d / std::hypot(d, 1.5))) / 64;
            }
            ASSERT_NEAR(seen, expected, 3.0e-3);
        }
    }
}

std::shared_ptr<const Scene> lit_corner() {
    SmallScene s;
    const std::uint16_t white = s.add_matte({0.7F, 0.6F, 0.5F});
    s.add_quad(white, {-3, 0, 3}, {6, 0, 0}, {0, 0, -6});
    s.add_quad(white, {-3, 0, -3}, {6, 0, 0}, {0, 4, 0});
    s.add_quad(s.add_matte({0.8F, 0.1F, 0.1F}), {-0.5F, 0.6F, -1.5F}, {1, 0, 0}, {0, 0.3F, -1});
    s.scene().point_lights.push_back({{1, 2, 0}, vec3(3.0F)});
    s.scene().area_lights.push_back({{-1.5F, 3, -1}, {1, 0, 0}, {0, 0, 1}, vec3(4.0F)});
    s.scene().ambient = vec3(0.3F);
    s.scene().background = {0.1F, 0.2F, 0.4F};
    return s.finish();
}

const EyeView kCornerView = view_at({0, 1.8F, 2.9F}, {0, 0.8F, -1}, 96, 80);

TEST(Reference, WithoutBouncesItConvergesToWhatFullEstimates) {
    RenderSettings settings = reference(64, 0);
    settings.lighting.area_samples = 32;
    settings.lighting.ao_samples = 32;
    settings.lighting.ao_radius_m = 1.5;
    const auto scene = lit_corner();
    const Image truth = converged(scene, settings, kCornerView);
    settings.pipeline = "full";
    // 24 frames of `full`, each with sample points of its own.
    const auto full = make_renderer(scene, settings);
    std::vector<dvec3> sum(truth.pixels.size());
    for (std::uint32_t frame = 0; frame < 24; ++frame) {
        full->render(frame_of(kCornerView, frame));
        const Image image = full->image(0);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += dvec3(image.pixels[i]) / 24.0;
    }
    double squares = 0.0;
    int even = 0;  // pixels without an edge: the same light in the neighbours
    dvec3 offset(0.0);
    const auto near = [&](std::size_t i, std::size_t j) {
        return glm::length(sum[i] - sum[j]) < 0.02;
    };
    for (int y = 1; y < 79; ++y) {
        for (int x = 1; x < 95; ++x) {
            const auto i = static_cast<std::size_t>(y * 96 + x);
            if (!(near(i, i - 1) && near(i, i + 1) && near(i, i - 96) && near(i, i + 96))) continue;
            const dvec3 d = dvec3(truth.pixels[i]) - sum[i];
            offset += d;
            squares += glm::dot(d, d) / 3.0;
            ++even;
        }
    }
    ASSERT_GT(even, 4000);
    EXPECT_LT(std::sqrt(squares / even), 0.015);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(offset[c] / even, 0.0, 6.0e-4);
}

TEST(Reference, BouncesOnlyAddLight) {
    const dvec3 direct = mean(converged(lit_corner(), reference(16, 0), kCornerView));
    const dvec3 one = mean(converged(lit_corner(), reference(16, 1), kCornerView));
    const dvec3 four = mean(converged(lit_corner(), reference(16, 4), kCornerView));
    for (int c = 0; c < 3; ++c) {
        EXPECT_GT(one[c], 1.01 * direct[c]);
        EXPECT_GT(four[c], one[c]);
    }
}

TEST(Reference, AMirrorShowsLampsAndBackgroundAndIsPlainAtTheLastVertex) {
    // A mirror floor; a glowing ceiling over its right half, sky over its left.
    SmallScene s;
    Material mirror;
    mirror.diffuse = vec3(0.5F);
    mirror.reflectance = 1.0F;
    s.add_quad(s.add_material(mirror), {-50, 0, 50}, {100, 0, 0}, {0, 0, -100});
    Material lamp;
    lamp.diffuse = vec3(0.0F);
    lamp.emission = {3.0F, 2.0F, 1.0F};
    s.add_quad(s.add_material(lamp), {0, 8, -500}, {500, 0, 0}, {0, 0, 1000});
    s.scene().ambient = vec3(0.2F);
    s.scene().background = {0.25F, 0.5F, 0.75F};
    const auto scene = s.finish();
    const EyeView view = view_at({0, 2, 0}, {0, 0, -2}, 64, 64, 0.5F);
    const Image mirrored = converged(scene, reference(16, 1), view);
    const Image plain = converged(scene, reference(16, 0), view);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            if (x == 31 || x == 32) continue;
            ASSERT_LT(glm::length(mirrored.at(x, y) -
                                  (x > 32 ? vec3(3.0F, 2.0F, 1.0F) : vec3(0.25F, 0.5F, 0.75F))),
                      1.0e-5F)
                << x << ' ' << y;
            ASSERT_LT(glm::length(plain.at(x, y) - vec3(0.1F)), 1.0e-5F);
        }
    }
}

TEST(Reference, ALampThatIsSampledAsALightIsNotCountedTwice) {
    // The same area light with and without a glowing face in its place: the floor, seen alone, is
    // as bright.
    const auto room = [](bool face) {
        SmallScene s;
        s.add_quad(s.add_matte(vec3(0.7F)), {-3, 0, 3}, {6, 0, 0}, {0, 0, -6});
        Material lamp;
        lamp.diffuse = vec3(0.0F);
        lamp.emission = vec3(face ? 5.0F : 0.0F);
        s.add_quad(s.add_material(lamp), {-1, 2.01F, -1}, {2, 0, 0}, {0, 0, 2});
        s.scene().area_lights.push_back({{-1, 2, -1}, {2, 0, 0}, {0, 0, 2}, vec3(5.0F)});
        return s.finish();
    };
    const EyeView view = view_at({0, 1, 2}, {0, 0, 0}, 64, 64, 0.4F);
    EXPECT_TRUE(converged(room(true), reference(16, 3), view).pixels ==
                converged(room(false), reference(16, 3), view).pixels);
}

TEST(Reference, TheEstimatedErrorFallsAsTheRootOfTheSamplesAndIsTrue) {
    RenderSettings settings = reference(512, 2);
    const auto scene = lit_corner();
    settings.seed = 99;
    const Image truth = converged(scene, settings, kCornerView);
    settings.seed = 1;
    const auto renderer = make_renderer(scene, settings);
    EXPECT_LT(renderer->estimated_error(), 0.0);
    double error_8 = 0.0;
    for (int samples = 8; samples <= 32; samples += 8) {
        renderer->render(frame_of(kCornerView));
        if (samples == 8) error_8 = renderer->estimated_error();
    }
    const double error_32 = renderer->estimated_error();
    EXPECT_LT(error_32, 0.62 * error_8);  // 0.5 for independent samples; a net does better
    EXPECT_GT(error_32, 0.15 * error_8);
    const Image image = renderer->image(0);
    double squares = 0.0;
    double level = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const dvec3 d = dvec3(image.pixels[i]) - dvec3(truth.pixels[i]);
        squares += glm::dot(d, d);
        level += glm::dot(dvec3(truth.pixels[i]), dvec3(truth.pixels[i]));
    }
    EXPECT_NEAR(std::sqrt(squares / level) / error_32, 1.0, 0.25);
}

TEST(Reference, StopsAtItsSamplesAndAtItsTargetError) {
    auto renderer = make_renderer(lit_corner(), reference(20, 1));
    std::uint64_t primary = 0;
    for (int call = 0; call < 5; ++call)
        primary += renderer->render(frame_of(kCornerView)).rays.primary;
    EXPECT_EQ(primary, 20U * 96U * 80U);
    RenderSettings settings = reference(4096, 1);
    settings.reference.target_error = 0.05;
    renderer = make_renderer(lit_corner(), settings);
    finish(*renderer, frame_of(kCornerView));
    EXPECT_LE(renderer->estimated_error(), 0.05);
    EXPECT_GT(renderer->estimated_error(), 0.01);
}

TEST(Reference, StartsAgainWhenTheViewOrTheTimeChangesAndOnlyThen) {
    const auto renderer = make_renderer(lit_corner(), reference(64, 1));
    EyeView moved = kCornerView;
    moved.position_m.x += 0.5F;
    for (int call = 0; call < 3; ++call) renderer->render(frame_of(kCornerView));
    renderer->render(frame_of(moved));
    const auto fresh = make_renderer(lit_corner(), reference(64, 1));
    fresh->render(frame_of(moved));
    EXPECT_TRUE(renderer->image(0).pixels == fresh->image(0).pixels);
    FrameInput later = frame_of(moved, 77);
    later.eyes[0].gaze = glm::normalize(vec3(0.3F, 0.1F, -1.0F));
    renderer->render(later);  // gaze and frame number do not matter
    fresh->render(frame_of(moved));
    EXPECT_TRUE(renderer->image(0).pixels == fresh->image(0).pixels);
    later.time_s = 1.0;
    renderer->render(later);
    const auto another = make_renderer(lit_corner(), reference(64, 1));
    another->render(later);
    EXPECT_TRUE(renderer->image(0).pixels == another->image(0).pixels);
}

TEST(Reference, ThreadsDoNotChangeABit) {
    const auto scene = std::make_shared<const Scene>(make_builtin_scene("cornell", 0.25));
    RenderSettings settings = reference(16, 3);
    settings.lighting.ao_samples = 1;
    const EyeView view =
        view_at(scene->camera_path[0].position_m, scene->camera_path[0].target_m, 130, 70);
    settings.threads = 1;
    const Image one = converged(scene, settings, view);
    settings.threads = 3;
    EXPECT_TRUE(one.pixels == converged(scene, settings, view).pixels);
}

TEST(Reference, CountsItsRaysAndNoNan) {
    const auto scene = std::make_shared<const Scene>(make_builtin_scene("cornell", 0.25));
    const auto renderer = make_renderer(scene, reference(8, 2));
    const FrameStats stats = renderer->render(frame_of(
        view_at(scene->camera_path[0].position_m, scene->camera_path[0].target_m, 64, 64)));
    EXPECT_EQ(stats.rays.primary, 8U * 64U * 64U);
    EXPECT_EQ(stats.sampled_pixels, 64U * 64U);
    EXPECT_GT(stats.rays.probe, stats.rays.primary);
    EXPECT_GT(stats.rays.reflection, 0U);
    EXPECT_EQ(stats.numerics.nan + stats.numerics.inf, 0U);
}

}  // namespace
}  // namespace foverig
