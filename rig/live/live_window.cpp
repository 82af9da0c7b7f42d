#include "rig/live/live_window.h"

#include "rig/live/cursor_gaze.h"
#include "rig/live/open_window.h"

namespace foverig {
namespace {

constexpr char kHudKey = 'H';

}  // namespace

std::unique_ptr<LiveWindow> LiveWindow::open(const Scenario& scenario) {
    const bool sees_through = !scenario.see_through.camera.empty();
    if (scenario.display.kind == "virtual") {
        if (!sees_through) return nullptr;
        throw UsageError("see_through.camera = " + scenario.see_through.camera +
                         " and display.kind = virtual: only a window shows a camera's picture; add "
                         "--display window, or --set see_through.camera= to go without");
    }
    auto opened = open_window(scenario, "foverig: " + scenario.scene);
    auto painter = window_or_throw(
        scenario, window::LensPainter::make(EyeMap(scenario.display.distortion), sees_through));
    return std::unique_ptr<LiveWindow>(
        new LiveWindow(scenario, std::move(opened), std::move(painter)));
}

LiveWindow::LiveWindow(const Scenario& scenario, std::unique_ptr<window::Window> window,
                       window::LensPainter painter)
    : scenario_(scenario),
      window_(std::move(window)),
      painter_(std::move(painter)),
      map_(scenario.display.distortion),
      parts_{.make_display = [this](const Clock& clock) { return make_display(clock); },
             .pointed_eyes = &eyes_},
      rate_hz_(scenario.display.rate_hz) {}

std::unique_ptr<Display> LiveWindow::make_display(const Clock& clock) {
    auto display = std::make_unique<window::WindowDisplay>(
        *window_, painter_, clock,
        [this](const PanelView& view) {
            if (!hud_) return;
            hud_->draw(view);
            ++hud_frames_;
        },
        window::WindowDisplay::Settings{.rate_hz = scenario_.display.rate_hz,
                                        .wait_vsync = scenario_.window.wait_vsync});
    rate_hz_ = display->timing().refresh_hz;
    if (scenario_.window.hud) toggle_hud();
    return display;
}

void LiveWindow::toggle_hud() {
    if (hud_)
        hud_.reset();
    else
        hud_ = std::make_unique<Hud>(scenario_, rate_hz_);
}

void LiveWindow::frame_begins(HostTime begin) {
    window_->poll();
    for (const char letter : window_->take_letters())
        if (letter == kHudKey) toggle_hud();
    const auto cursor_px = window_->cursor_px();
    if (!cursor_px) return;
    if (const auto place = window_->view().place(*cursor_px))
        eyes_.look(to_seconds(begin.time_since_epoch()), looking_at(*place, map_));
}

void LiveWindow::frame_done(const FrameRecord& frame) {
    if (hud_) hud_->add(frame);
}

void LiveWindow::complete(DisplayRecord& record) const {
    record.shown_on = window_->shown_on();
    record.on_headset = scenario_.display.kind == "headset";
    record.hud_frames = hud_frames_;
}

}  // namespace foverig
