// Whole-frame passes, as the GPU runs them, against the tiles of the `full` pipeline.
#include "renderer/pipelines/full_frame.h"

#include <gtest/gtest.h>

#include "renderer/backends/host_bvh/host_backend.h"
#include "renderer/scene/library.h"
#include "tests/renderer/small_scenes.h"

namespace foverig {
namespace {

using host_bvh::HostBackend;

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

void expect_image_of_tiles(const std::shared_ptr<const Scene>& scene, int area_samples,
                           int ao_samples) {
    RenderSettings settings = settings_of("full");
    settings.backend = "host-bvh";
    settings.lighting.area_samples = area_samples;
    settings.lighting.ao_samples = ao_samples;
    const EyeView view = view_of_scene(*scene);
    const auto tiles = make_renderer(scene, settings);
    const FrameStats stats = tiles->render(frame_of(view, 3));
    const Image expected = tiles->image(0);

    const host_bvh::HostBvhScene traced(*scene, {});
    HostBackend backend(traced);
    FullFrame<HostBackend> frame(backend, *scene, settings);
    frame.render(view, 3);
    const std::vector<Half4> image = frame.image();
    ASSERT_EQ(image.size(), expected.pixels.size());
    // One source compiled twice may be contracted differently: a float's last bits, which can turn
    // one half into the next.
    std::size_t different = 0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        const vec3 got = vec3(unpack_half4(image[i]));
        const vec3 step = 0x1.0p-10F * expected.pixels[i] + 0x1.0p-24F;
        different += glm::any(glm::greaterThan(glm::abs(got - expected.pixels[i]), step)) ? 1U : 0U;
    }
    EXPECT_EQ(different, 0U) << scene->name;
    EXPECT_EQ(frame.numerics().nan, 0U);
    std::uint64_t rays = 0;
    const PassTable passes = backend.take_passes();
    for (const PassTable::Entry& e : passes.entries()) rays += e.rays;
    EXPECT_EQ(rays, stats.rays.total());
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

TEST(FrameQueue, HoldsEveryPixelOnceInBlocksOfAWarp) {
    for (const auto& [width, height] :
         std::vector<std::pair<int, int>>{{16, 8}, {13, 7}, {1, 1}, {3, 9}, {64, 5}}) {
        std::vector<PackedPixel> pixels(static_cast<std::size_t>(width * height));
        const QueuePixels kernel{width, height, view_of(pixels)};
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
    const QueuePixels kernel{16, 8, view_of(pixels)};
    for (int i = 0; i < 128; ++i) kernel(i);
    for (std::uint32_t i = 0; i < 128; ++i) {
        EXPECT_EQ(pixel_x(pixels[i]) / 8, i / 32 % 2);
        EXPECT_EQ(pixel_y(pixels[i]) / 4, i / 64);
    }
}

}  // namespace
}  // namespace foverig
