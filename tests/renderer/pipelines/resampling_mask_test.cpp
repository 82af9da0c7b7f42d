// The resampling info as the `reprojected` pipeline finds it, on scenes whose answer is plain.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "tests/renderer/small_scenes.h"

namespace foverig {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 396;

std::shared_ptr<const Scene> wall_scene() {
    SmallScene s;
    s.add_quad(s.add_matte(vec3(0.5F)), {-40, -40, -3}, {80, 0, 0}, {0, 80, 0});
    s.scene().ambient = vec3(0.5F);
    return s.finish();
}

int marked_pixels(const std::shared_ptr<const Scene>& scene,
                  const std::function<EyeView(int)>& view) {
    const auto renderer = make_renderer(scene, settings_of("reprojected"));
    for (int frame = 0; frame < 3; ++frame)
        renderer->render(frame_of(view(frame), static_cast<std::uint32_t>(frame)));
    const Mask mask = renderer->resampling_mask(0);
    return static_cast<int>(std::count(mask.pixels.begin(), mask.pixels.end(), std::uint8_t{1}));
}

TEST(ResamplingMask, AFlatFrontalWallIsNotResampled) {
    EXPECT_EQ(marked_pixels(wall_scene(),
                            [](int) {
                                return view_at({0, 0, 0}, {0, 0, -1}, kWidth, kHeight);
                            }),
              0);
}

TEST(ResamplingMask, AStepBackUncoversTheBorder) {
    const int marked = marked_pixels(wall_scene(), [](int frame) {
        return view_at({0, 0, 0.3F * static_cast<float>(frame)}, {0, 0, -1}, kWidth, kHeight);
    });
    EXPECT_GT(marked, 100);
    EXPECT_LT(marked, kWidth * kHeight / 4);
}

TEST(ResamplingMask, AFloorIsResampledNearItsHorizonOnly) {
    SmallScene s;
    s.add_quad(s.add_matte(vec3(0.5F)), {-400, 0, 400}, {800, 0, 0}, {0, 0, -800});
    s.scene().ambient = vec3(0.5F);
    const auto renderer = make_renderer(s.finish(), settings_of("reprojected"));
    const EyeView view = view_at({0, 1.5F, 0}, {0, 1.5F, -1}, kWidth, kHeight);
    for (std::uint32_t frame = 0; frame < 3; ++frame) renderer->render(frame_of(view, frame));
    const Mask mask = renderer->resampling_mask(0);
    const auto marked = [&](int y) {
        return mask.pixels[static_cast<std::size_t>(y * kWidth + kWidth / 2)] == 1;
    };
    EXPECT_TRUE(marked(kHeight / 2 + 4)) << "the floor is seen at a grazing angle";
    EXPECT_FALSE(marked(kHeight - 8)) << "the floor at one's feet is not";
    EXPECT_FALSE(marked(kHeight / 4)) << "nor is the sky";
}

}  // namespace
}  // namespace foverig
