#include "devices/display/panel_view.h"

#include <gtest/gtest.h>

namespace foverig {
namespace {

TEST(PanelView, FillsAFramebufferOfThePanelsShape) {
    const PanelView view({1920, 1080}, false);
    EXPECT_EQ(view.viewport().width_px, 1920);
    EXPECT_EQ(view.viewport().height_px, 1080);
    EXPECT_EQ(view.viewport().x_px + view.viewport().y_px, 0);
    const auto lower_left = view.place({0.0, 1080.0});
    ASSERT_TRUE(lower_left);
    EXPECT_EQ(lower_left->eye, Eye::left);
    EXPECT_EQ(lower_left->ndc, dvec2(-1.0, -1.0));
    const auto right = view.place({1440.0, 270.0});
    ASSERT_TRUE(right);
    EXPECT_EQ(right->eye, Eye::right);
    EXPECT_EQ(right->ndc, dvec2(0.0, 0.5));
}

TEST(PanelView, LeavesBarsBesideThePanel) {
    const PanelView view({1000, 1000}, false);  // 16:9 of it: 1000x562.5
    EXPECT_EQ(view.viewport().width_px, 1000);
    EXPECT_EQ(view.viewport().height_px, 563);
    EXPECT_FALSE(view.place({500.0, 100.0}));
    EXPECT_TRUE(view.place({500.0, 500.0}));
    EXPECT_FALSE(view.place({500.0, 900.0}));
}

TEST(PanelView, ComesBackToThePixelItCameFrom) {
    for (const PanelView& view : {PanelView({1280, 720}, false), PanelView({1000, 1000}, false),
                                  PanelView({1080, 1920}, true), PanelView({1200, 1920}, true)}) {
        for (const dvec2& at_px : {dvec2(300.0, 500.0), dvec2(900.0, 400.0), dvec2(620.0, 610.0)}) {
            const auto place = view.place(at_px);
            ASSERT_TRUE(place);
            EXPECT_NEAR(glm::distance(view.at_px(*place), at_px), 0.0, 1e-9);
        }
    }
}

// DEVICES.md 1.7: the pixel that is read back is the upper left one of the portrait scan, and the
// upper right one of the landscape picture; 2.3: the portrait's top is the landscape's right.
TEST(PanelView, APortraitPanelShowsTheRightEyeOnTop) {
    const PanelView view({1080, 1920}, true);
    EXPECT_EQ(view.place({540.0, 10.0})->eye, Eye::right);
    EXPECT_EQ(view.place({540.0, 1910.0})->eye, Eye::left);
    EXPECT_GT(view.place({10.0, 480.0})->ndc.y, 0.9) << "up is left";
    EXPECT_EQ(view.latency_pixel().x_px, 0);
    EXPECT_EQ(view.latency_pixel().y_px, 1919);
    EXPECT_EQ(PanelView({1920, 1080}, false).latency_pixel().x_px, 1919);
    EXPECT_EQ(PanelView({1920, 1080}, false).latency_pixel().y_px, 1079);
}

}  // namespace
}  // namespace foverig
