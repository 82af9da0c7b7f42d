// Whole-frame passes, as the GPU runs them, against the tiles of the `full` pipeline.
#include "renderer/pipelines/frame/full_frame.h"

#include <gtest/gtest.h>

#include "renderer/backends/host_bvh/host_backend.h"
#include "renderer/pipelines/frame/frame_renderer.h"
#include "renderer/scene/library.h"
#include "tests/renderer/small_scenes.h"

namespace foverig {
namespace {

using FrameTwin = FrameRenderer<host_bvh::HostBackend, FullFrame>;

/// Odd sizes: blocks of pixels and tiles are cut off at both edges.
EyeView view_of_scene(const Scene& scene) {
    const CameraKey& key = scene.camera_path[0];
    return view_at(key.position_m, key.target_m, 133, 71);
}

/// One bulb and one lamp, so that every kind of light has its passes.
std::shared_ptr<const Scene> lit(const char* name) {
    Scene scene = make_builtin_scene(name, 0.1);
    const vec3 middle = 0.5F * (scene.bounds.min_m + scene.bounds.max_m);
    scene.point_lights = {{middle, vec3(20.0F)}};
    scene.area_lights = {{middle, vec3(0.5F, 0, 0), vec3(0, 0, 0.5F), vec3(9.0F)},
                         {middle + vec3(1.0F), vec3(0.5F, 0, 0), vec3(0, 0, 0.5F), vec3(9.0F)}};
    return std::make_shared<const Scene>(std::move(scene));
}

/// One source compiled twice may be contracted differently: a float's last bits, which can turn one
/// half into the next.
std::size_t pixels_apart(const Image& a, const Image& b) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const vec3 step = 0x1.0p-10F * a.pixels[i] + 0x1.0p-24F;
        const vec3 apart = glm::abs(a.pixels[i] - b.pixels[i]);
        different += glm::any(glm::greaterThan(apart, step)) ? 1U : 0U;
    }
    return different;
}

void expect_image_of_tiles(const std::shared_ptr<const Scene>& scene, int area_samples,
                           int ao_samples) {
    RenderSettings settings = settings_of("full");
    settings.backend = "host-bvh";
    settings.lighting.area_samples = area_samples;
    settings.lighting.ao_samples = ao_samples;
    FrameInput input = frame_of(view_of_scene(*scene), 3);
    input.eyes.push_back(input.eyes[0]);
    input.eyes[1].view.position_m.x += 0.064F;
    const auto tiles = make_renderer(scene, settings);
    const FrameStats expected = tiles->render(input);
    FrameTwin frames(scene, settings, {});
    const FrameStats stats = frames.render(input);
    for (int eye = 0; eye < 2; ++eye) {
        ASSERT_EQ(frames.image(eye).pixels.size(), tiles->image(eye).pixels.size());
        EXPECT_EQ(pixels_apart(tiles->image(eye), frames.image(eye)), 0U)
            << scene->name << ", eye " << eye;
    }
    EXPECT_EQ(stats.numerics.nan, 0U);
    EXPECT_EQ(stats.rays.primary, expected.rays.primary);
    EXPECT_EQ(stats.rays.shadow, expected.rays.shadow);
    EXPECT_EQ(stats.rays.ao, expected.rays.ao);
}

TEST(FullFrame, IsTheImageOfTheTilesToAStepOfAHalf) {
    expect_image_of_tiles(lit("atrium"), 4, 4);
    expect_image_of_tiles(lit("cornell"), 2, 3);
}
TEST(FullFrame, IsTheImageOfTheTilesWithoutSampledLight) {
    expect_image_of_tiles(lit("atrium"), 0, 0);
}
TEST(FullFrame, IsTheImageOfTheTilesWithOneKindOfSampledLight) {
    expect_image_of_tiles(lit("cornell"), 8, 0);
    expect_image_of_tiles(lit("cornell"), 0, 16);
}

TEST(FullFrame, OneEyeIsTheFirstOfTwo) {
    const auto scene = lit("atrium");
    const FrameInput one = frame_of(view_of_scene(*scene), 3);
    FrameInput two = one;
    two.eyes.push_back(one.eyes[0]);
    FrameTwin alone(scene, settings_of("full"), {});
    FrameTwin both(scene, settings_of("full"), {});
    alone.render(one);
    both.render(two);
    EXPECT_EQ(alone.image(0).pixels, both.image(0).pixels);
    EXPECT_EQ(alone.image(0).pixels, both.image(1).pixels);
}

TEST(FullFrame, RefusesEyesOfTwoSizes) {
    const auto scene = lit("cornell");
    FrameInput input = frame_of(view_of_scene(*scene), 3);
    input.eyes.push_back(input.eyes[0]);
    input.eyes[1].view.width_px += 1;
    FrameTwin frames(scene, settings_of("full"), {});
    EXPECT_THROW(frames.render(input), std::invalid_argument);
}

TEST(FrameQueue, HoldsEveryPixelOnceInBlocksOfAWarp) {
    for (const auto& [width, height] :
         std::vector<std::pair<int, int>>{{16, 8}, {13, 7}, {1, 1}, {3, 9}, {64, 5}}) {
        std::vector<PackedPixel> pixels(static_cast<std::size_t>(width * height));
        const QueuePixels kernel{width, height, view_of(pixels), 0};
        for (int i = 0; i < width * height; ++i) kernel(i);
        std::vector<int> seen(pixels.size());
        for (const PackedPixel p : pixels) {
            ASSERT_LT(pixel_x(p), static_cast<std::uint32_t>(width));
            ASSERT_LT(pixel_y(p), static_cast<std::uint32_t>(height));
            ++seen[pixel_y(p) * static_cast<std::uint32_t>(width) + pixel_x(p)];
        }
        EXPECT_EQ(seen, std::vector<int>(pixels.size(), 1)) << width << " x " << height;
    }
    std::vector<PackedPixel> pixels(16 * 8);
    const QueuePixels kernel{16, 8, view_of(pixels), 0};
    for (int i = 0; i < 128; ++i) kernel(i);
    for (std::uint32_t i = 0; i < 128; ++i) {
        EXPECT_EQ(pixel_x(pixels[i]) / 8, i / 32 % 2);
        EXPECT_EQ(pixel_y(pixels[i]) / 4, i / 64);
    }
}

}  // namespace
}  // namespace foverig
