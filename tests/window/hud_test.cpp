#include "rig/live/hud.h"

#include <gtest/gtest.h>

#include "devices/window/window.h"
#include "tests/window/pictures.h"
#include "tests/window/xvfb.h"

namespace foverig {
namespace {

using test::Shot;

class HudTest : public test::OnADesktop {
  protected:
    void SetUp() override {
        OnADesktop::SetUp();
        auto window = window::Window::open({.size = {1280, 720}});
        ASSERT_TRUE(window) << window.error().text;
        window_ = std::move(window).value();
    }
    /// Over grey. A window of Dear ImGui's knows its size from its second frame on.
    static void draw(Hud& hud, const PanelView& view) {
        for (int i = 0; i < 2; ++i) {
            glClearColor(0.3F, 0.3F, 0.3F, 1.0F);
            glClear(GL_COLOR_BUFFER_BIT);
            hud.draw(view);
        }
    }
    /// 300 frames, of which each tenth takes longer than the budget of 13.3 ms.
    static void fill(Hud& hud) {
        for (std::uint32_t i = 0; i < 300; ++i) {
            FrameRecord frame;
            frame.frame = i;
            frame.present = frame.begin + from_seconds(i % 10 == 9 ? 0.020 : 0.009);
            frame.shown_vsync = i + i / 10;
            frame.missed_vsyncs = i > 0 && i % 10 == 0 ? 1 : 0;
            frame.pose = SampleInstants{};
            frame.photon = HostTime(Nanoseconds(21'400'000));
            frame.gaze_direction = {glm::normalize(vec3(0.3F, 0.15F, -1.0F)),
                                    glm::normalize(vec3(0.26F, 0.15F, -1.0F))};
            hud.add(frame);
        }
    }
    std::unique_ptr<window::Window> window_;
};

std::size_t changed(const Shot& shot, const PanelView::Rectangle& where) {
    std::size_t count = 0;
    for (int y = where.y_px; y < where.y_px + where.height_px; ++y)
        for (int x = where.x_px; x < where.x_px + where.width_px; ++x)
            for (int c = 0; c < 3; ++c)
                if (shot.at(x, y)[c] < 75 || shot.at(x, y)[c] > 78) {
                    ++count;
                    break;
                }
    return count;
}

TEST_F(HudTest, DrawsNumbersAndGazeAndLeavesTheRestAlone) {
    Scenario scenario;
    const PanelView view({1280, 720}, false);
    Hud hud(scenario, 75.0);
    fill(hud);
    draw(hud, view);
    const Shot shot = test::shot_of_framebuffer(1280, 720);
    test::keep(shot, "hud");
    EXPECT_GT(changed(shot, {16, 16, 370, 190}), 60'000U) << "the numbers' plate";
    EXPECT_EQ(changed(shot, {0, 500, 1280, 220}), 0U) << "below the rings";
    EXPECT_EQ(changed(shot, {0, 300, 150, 420}), 0U);
    const EyeMap map(true);
    for (const Eye eye : {Eye::left, Eye::right}) {
        const dvec2 tangent(eye == Eye::left ? 0.3 : 0.26, 0.15);
        const dvec2 dot = view.at_px({eye, map.ndc(eye, tangent)});
        const auto* pixel = shot.at(static_cast<int>(dot.x), static_cast<int>(dot.y));
        EXPECT_GT(pixel[0], 200) << "a red dot where the eye looks";
        EXPECT_LT(pixel[2], 100);
    }
}

TEST_F(HudTest, TurnsWithThePanel) {
    Scenario scenario;
    Hud hud(scenario, 75.0);
    fill(hud);
    const test::Canvas upright(1080, 1920);
    draw(hud, PanelView({1080, 1920}, true));
    const Shot portrait = test::shot_of_framebuffer(1080, 1920);
    test::keep(portrait, "hud_portrait");
    const test::Canvas level(1920, 1080);
    draw(hud, PanelView({1920, 1080}, false));
    const Shot landscape = test::shot_of_framebuffer(1920, 1080);
    test::keep(landscape, "hud_landscape");
    // Edges are rasterised at other places of a pixel: but for these they are the same.
    std::size_t different = 0;
    for (int y = 0; y < 1920; ++y)
        for (int x = 0; x < 1080; ++x)
            if (std::abs(portrait.at(x, y)[1] - landscape.at(1919 - y, x)[1]) > 40) ++different;
    EXPECT_LT(different, 1080U * 1920U / 200U);
    EXPECT_GT(changed(landscape, {24, 24, 500, 250}), 100'000U);
}

}  // namespace
}  // namespace foverig
