#include "rig/live/live_window.h"

#include <gtest/gtest.h>

#include "tests/window/pictures.h"
#include "tests/window/xvfb.h"
// Xlib last: its macros.
#include "tests/window/person.h"

namespace foverig {
namespace {

class LiveWindowTest : public test::OnADesktop {
  protected:
    void SetUp() override {
        OnADesktop::SetUp();
        scenario_.display.kind = "window";
        scenario_.clock = "wall";
        scenario_.window.width_px = 960;
        live_ = LiveWindow::open(scenario_);
        ASSERT_NE(live_, nullptr);
        display_ = live_->parts().make_display(clock_);
    }
    test::Shot drawn() {
        FramePictures frame;
        frame.eyes = 2;
        frame.pictures = {left_.view(), right_.view()};
        display_->draw(frame);
        return test::shot_of_framebuffer(960, 540);
    }
    std::uint64_t hud_frames() const {
        DisplayRecord record;
        live_->complete(record);
        return record.hud_frames;
    }
    /// Draws until `condition`, as a run would; false if it never comes.
    bool drawn_until(const std::function<bool()>& condition) {
        for (int i = 0; i < 500; ++i) {
            live_->frame_begins(clock_.now());
            drawn();
            if (condition()) return true;
        }
        return false;
    }

    Scenario scenario_;
    WallClock clock_;
    test::HalfPicture left_{test::waves(0)}, right_{test::waves(1)};
    std::unique_ptr<LiveWindow> live_;
    std::unique_ptr<Display> display_;
};

TEST_F(LiveWindowTest, AKeyShowsTheHudAndTakesItAway) {
    test::Person person;
    const auto target = person.window_titled("foverig: atrium");
    ASSERT_TRUE(target);
    const test::Shot bare = drawn();
    EXPECT_EQ(hud_frames(), 0U);

    person.press(*target, XK_h);
    ASSERT_TRUE(drawn_until([&] { return hud_frames() >= 2; }));
    const test::Shot shown = drawn();
    test::keep(shown, "window_hud");
    EXPECT_NE(shown.rgb, bare.rgb);

    person.press(*target, XK_h);
    ASSERT_TRUE(drawn_until([&, before = hud_frames()]() mutable {
        const bool off = hud_frames() == before;
        before = hud_frames();
        return off;
    }));
    EXPECT_EQ(drawn().rgb, bare.rgb) << "nothing of it is left";
}

TEST_F(LiveWindowTest, TheEyesFollowTheCursor) {
    test::Person person;
    const motion::EyeMotion& eyes = *live_->parts().pointed_eyes;
    const auto gaze_x = [&] { return eyes.at(1e6).direction.x; };
    person.move_to(400, 270);
    EXPECT_TRUE(drawn_until([&] { return gaze_x() > 0.1; }));
    person.move_to(500, 270);
    EXPECT_TRUE(drawn_until([&] { return gaze_x() < -0.1; })) << "the right eye's left edge";
}

}  // namespace
}  // namespace foverig
