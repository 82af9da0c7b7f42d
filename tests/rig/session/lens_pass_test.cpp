#include "rig/session/lens_pass.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/rig/session/fake_renderer.h"

namespace foverig {
namespace {

/// Colour tells the place: red grows to the right, green downwards, from 0 to 1.
Image ramp(int width_px, int height_px) {
    Image image{width_px, height_px, {}};
    for (int y = 0; y < height_px; ++y) {
        for (int x = 0; x < width_px; ++x) {
            const float u = (static_cast<float>(x) + 0.5F) / static_cast<float>(width_px);
            const float v = (static_cast<float>(y) + 0.5F) / static_cast<float>(height_px);
            image.pixels.emplace_back(u, v, 0.5F);
        }
    }
    return image;
}

Image panel_of(const Image& left, const Image& right) {
    Scenario s;
    s.display.eye_width_px = std::max(left.width_px, right.width_px);
    s.display.eye_height_px = std::max(left.height_px, right.height_px);
    const std::vector<Image> eyes{left, right};
    return LensPass(s).picture(eyes);
}

// Straight ahead (tangent 0) lies at tan_left / (tan_left + tan_right) of the image: 1.058657 and
// 1.092368 for the left eye (DEVICES.md 2.2); on the panel at the lens centre, x = -0.009860 in
// NDC.
TEST(LensPass, PutsStraightAheadAtTheLensCentre) {
    const Image panel = panel_of(ramp(400, 500), ramp(400, 500));
    ASSERT_EQ(panel.width_px, 1920);
    ASSERT_EQ(panel.height_px, 1080);
    const int left_x = static_cast<int>((1.0 - 0.009860) * 0.5 * 960.0);
    EXPECT_NEAR(panel.at(left_x, 540).x, 1.058657 / 2.151025, 2e-3);
    EXPECT_NEAR(panel.at(left_x, 540).y, 0.5, 2e-3);
    const int right_x = 960 + static_cast<int>((1.0 + 0.009860) * 0.5 * 960.0);
    EXPECT_NEAR(panel.at(right_x, 540).x, 1.092368 / 2.151025, 2e-3);
}

TEST(LensPass, BendsOutwardsAndSplitsColours) {
    const Image white{64, 64, std::vector<vec3>(64U * 64U, vec3(1.0F))};
    const Image panel = panel_of(white, white);
    // Red reaches furthest in (its scale is smallest), so a far corner may lack blue but not red.
    std::size_t fringe = 0;
    for (const vec3& pixel : panel.pixels) {
        if (pixel.x > 0.5F && pixel.z < 0.5F) ++fringe;
        EXPECT_FALSE(pixel.x < 0.5F && pixel.z > 0.5F);
    }
    EXPECT_GT(fringe, 100U);
    EXPECT_EQ(panel.at(0, 0), vec3(0.0F));
}

TEST(LensPass, LeavesTheHalfOfAMissingEyeBlack) {
    const Image panel = panel_of(ramp(40, 50), Image{});
    EXPECT_GT(panel.at(480, 540).x, 0.0F);
    EXPECT_EQ(panel.at(1440, 540), vec3(0.0F));
}

TEST(LensPass, TimesItsParts) {
    Scenario s;
    s.display.eye_width_px = 2;
    s.display.eye_height_px = 2;
    const auto passes = LensPass(s).run(FakeRenderer());
    ASSERT_EQ(passes.size(), 1U);
    EXPECT_EQ(passes[0].name, "lens_distortion");
    EXPECT_GT(passes[0].ms, 0.0);
}

TEST(LensPass, DrawsHalfAPanelForOneEye) {
    Scenario s;
    s.display.eyes = 1;
    s.display.eye_width_px = 40;
    s.display.eye_height_px = 50;
    const std::vector<Image> eyes{ramp(40, 50)};
    EXPECT_EQ(LensPass(s).picture(eyes).width_px, 960);
}

}  // namespace
}  // namespace foverig
