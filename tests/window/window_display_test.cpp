#include "devices/window/window_display.h"

#include <gtest/gtest.h>

#include "tests/window/pictures.h"
#include "tests/window/xvfb.h"
// Xlib last: its macros.
#include "tests/window/person.h"

namespace foverig {
namespace {

using test::Shot;
using test::shot_of_framebuffer;

class WindowDisplayTest : public test::OnADesktop {
  protected:
    void open(const window::Window::Settings& settings = {.size = {960, 540}},
              window::WindowDisplay::Overlay overlay = {}) {
        auto opened = window::Window::open(settings);
        ASSERT_TRUE(opened) << opened.error().text;
        window_ = std::move(opened).value();
        auto painter = window::LensPainter::make(EyeMap(true));
        ASSERT_TRUE(painter) << painter.error().text;
        painter_.emplace(std::move(painter).value());
        display_ = std::make_unique<window::WindowDisplay>(
            *window_, *painter_, clock_, std::move(overlay),
            window::WindowDisplay::Settings{.rate_hz = 75.0});
    }
    FramePictures frame() const {
        FramePictures frame;
        frame.eyes = 2;
        frame.pictures = {left_.view(), right_.view()};
        frame.world_from_head = {dquat(1, 0, 0, 0), dquat(1, 0, 0, 0)};
        return frame;
    }
    test::HalfPicture left_{test::waves(0)}, right_{test::waves(1)};
    WallClock clock_;
    std::unique_ptr<window::Window> window_;
    std::optional<window::LensPainter> painter_;
    std::unique_ptr<window::WindowDisplay> display_;
};

TEST_F(WindowDisplayTest, ShowsAFrameWithItsLatencyPixel) {
    ASSERT_NO_FATAL_FAILURE(open());
    for (std::uint64_t id = 0; id < 3; ++id) {
        const auto level = static_cast<std::uint8_t>(48 + 64 * id);
        const DrawTimes times = display_->draw(frame());
        EXPECT_GT(times.upload + times.lens, Nanoseconds(0));
        const HostTime submit = clock_.now();
        const Presentation shown_as =
            display_->present({.frame_id = id, .latency_level = level}, submit);
        EXPECT_EQ(shown_as.frame_id, id);
        EXPECT_GE(shown_as.vsync, submit);
        const test::Person person;
        EXPECT_EQ(person.colour_at(959, 0), (std::array<int, 3>{level, level, level}));
        EXPECT_LT(person.colour_at(958, 0)[0], 20) << "one pixel; the corner beside it is dark";
        EXPECT_GT(person.colour_at(240, 270)[1], 20) << "the picture";
    }
}

TEST_F(WindowDisplayTest, OwnsItsGridWhereSwapsTellNothing) {
    ASSERT_NO_FATAL_FAILURE(open());
    // Xvfb tells no rate and waits for nothing.
    EXPECT_EQ(display_->vsync_knowledge().source, VsyncKnowledge::Source::own_clock);
    EXPECT_NEAR(to_ms(display_->vsync_knowledge().error), 500.0 / 75.0, 1e-6);
    EXPECT_EQ(display_->timing().refresh_hz, 75.0);
    const HostTime now = clock_.now();
    const HostTime next = display_->next_vsync(now);
    EXPECT_GE(next, now);
    EXPECT_NEAR(to_ms(display_->next_vsync(next + Nanoseconds(1)) - next), 1000.0 / 75.0, 1e-5);
    // Two frames within one period: the first was never seen.
    std::uint64_t replaced = 0, frames = 0;
    std::uint64_t last = 0;
    for (; frames < 200; ++frames) {
        const Presentation p = display_->present({.frame_id = frames}, clock_.now());
        EXPECT_GE(p.vsync_number, last);
        EXPECT_EQ(p.replaced, frames > 0 && p.vsync_number == last);
        replaced += p.replaced ? 1 : 0;
        last = p.vsync_number;
    }
    EXPECT_LE(replaced, frames);
}

TEST_F(WindowDisplayTest, AsksForTheNewestHeadOnceAndTurnsThePictureToIt) {
    ASSERT_NO_FATAL_FAILURE(open());
    FramePictures still = frame();
    display_->draw(still);
    const Shot before = shot_of_framebuffer(960, 540);
    int asked = 0;
    still.newest = [&] {
        ++asked;
        return std::array{dquat(dvec3(0.0, 0.1, 0.0)), dquat(dvec3(0.0, 0.1, 0.0))};
    };
    display_->draw(still);
    EXPECT_EQ(asked, 1);
    EXPECT_NE(shot_of_framebuffer(960, 540).rgb, before.rgb);
    still.newest = [&] { return std::array{dquat(1, 0, 0, 0), dquat(1, 0, 0, 0)}; };
    display_->draw(still);
    EXPECT_EQ(shot_of_framebuffer(960, 540).rgb, before.rgb);
}

TEST_F(WindowDisplayTest, FillsTheMonitorThatIsNamed) {
    const auto monitors = window::list_monitors();
    ASSERT_TRUE(monitors) << monitors.error().text;
    ASSERT_EQ(monitors->size(), 1U);
    EXPECT_EQ(monitors->front().mode, (SizePx{1920, 1080}));
    ASSERT_NO_FATAL_FAILURE(open({.full_screen = true, .monitor = monitors->front().name}));
    EXPECT_EQ(window_->view().framebuffer(), (SizePx{1920, 1080}));
    EXPECT_NE(window_->shown_on().find("1920x1080"), std::string::npos);
    display_->draw(frame());
    display_->present({.latency_level = 240}, clock_.now());
    EXPECT_EQ(test::Person().colour_at(1919, 0)[0], 240);
}

TEST_F(WindowDisplayTest, RefusesAHeadsetThatIsNotThere) {
    const auto window = window::Window::open({.full_screen = true});
    ASSERT_FALSE(window);
    EXPECT_EQ(window.error().code, ErrorCode::not_found);
    EXPECT_NE(window.error().text.find("1920x1080"), std::string::npos) << "what there is instead";
}

TEST_F(WindowDisplayTest, KeysAndCursorReachIt) {
    ASSERT_NO_FATAL_FAILURE(open());
    test::Person person;
    const auto target = person.window_titled("foverig");
    ASSERT_TRUE(target);
    const auto polled_until = [&](auto condition) {
        for (int i = 0; i < 1000 && !condition(); ++i) {
            window_->poll();
            clock_.sleep_until(clock_.now() + Nanoseconds(2'000'000));
        }
        return condition();
    };
    person.press(*target, XK_h);
    std::string letters;
    EXPECT_TRUE(polled_until([&] {
        letters += window_->take_letters();
        return letters == "H";
    }));
    person.move_to(200, 100);
    EXPECT_TRUE(polled_until([&] { return window_->cursor_px() == dvec2(200.0, 100.0); }));
    person.move_to(1900, 1000);
    EXPECT_TRUE(polled_until([&] { return !window_->cursor_px(); })) << "beside it";
    EXPECT_FALSE(window_->closed());
    person.press(*target, XK_Escape);
    EXPECT_TRUE(polled_until([&] { return window_->closed(); }));
}

TEST(WindowWithoutADesktop, SaysSo) {
    (void)unsetenv("DISPLAY");
    const auto window = window::Window::open({});
    ASSERT_FALSE(window);
    EXPECT_EQ(window.error().code, ErrorCode::not_found);
    EXPECT_NE(window.error().text.find("DISPLAY"), std::string::npos);
    EXPECT_FALSE(window::list_monitors());
}

TEST(Monitors, TheDk2sIsKnownByItsSize) {
    using window::Monitor;
    const Monitor desk{"DP-1", {1920, 1080}, 60, 520, 290};
    const Monitor upright{"DP-2", {1080, 1920}, 60, 290, 520};
    const Monitor dk2{"HDMI-1", {1080, 1920}, 75, 71, 126};
    const Monitor turned{"HDMI-1", {1920, 1080}, 75, 126, 71};
    const Monitor named{"Rift DK2", {1080, 1920}, 75, 0, 0};
    const Monitor phone{"HDMI-2", {720, 1280}, 60, 71, 126};
    for (const Monitor& headset : {dk2, turned, named}) {
        const std::array all{desk, upright, phone, headset};
        EXPECT_EQ(window::dk2_among(all), 3U) << text_of(headset);
    }
    const std::array none{desk, upright, phone};
    EXPECT_FALSE(window::dk2_among(none));
    EXPECT_EQ(*window::choose_monitor(none, "DP-2"), 1U);
    EXPECT_NE(window::choose_monitor(none, "").error().text.find("DP-1 (1920x1080 at 60 Hz"),
              std::string::npos);
    EXPECT_FALSE(window::choose_monitor(none, "DP-3"));
}

}  // namespace
}  // namespace foverig
