#include "rig/live/live_window.h"

#include <fmt/format.h>

#include "rig/failure.h"
#include "rig/live/cursor_gaze.h"

namespace foverig {
namespace {

constexpr char kHudKey = 'H';

/// One sentence with what to do.
DeviceError failure_of(const Scenario& scenario, const Error& error) {
    const char* what_to_do = "update the graphics driver, or use --display virtual";
    if (error.code == ErrorCode::not_found)
        what_to_do = scenario.display.kind == "headset"
                         ? "foverig doctor says whether the headset is hidden from the desktop; "
                           "window.monitor names another one; or use --display window"
                         : "log in to a desktop (or set DISPLAY to one), or use --display virtual";
    return DeviceError(
        fmt::format("display.kind = {}: {}; {}", scenario.display.kind, error.text, what_to_do));
}

template <class T>
T or_throw(const Scenario& scenario, Result<T> result) {
    if (!result) throw failure_of(scenario, result.error());
    return std::move(result).value();
}

window::Window::Settings settings_of(const Scenario& scenario) {
    const int width_px = scenario.window.width_px;
    return {.title = "foverig: " + scenario.scene,
            .size = {width_px, width_px * 9 / 16},
            .full_screen = scenario.display.kind == "headset",
            .monitor = scenario.window.monitor,
            .rate_hz = scenario.display.rate_hz,
            .wait_vsync = scenario.window.wait_vsync};
}

}  // namespace

std::unique_ptr<LiveWindow> LiveWindow::open(const Scenario& scenario) {
    if (scenario.display.kind == "virtual") return nullptr;
    if (scenario.clock != "wall")
        throw UsageError(
            fmt::format("display.kind = {} and clock = {}: a window shows frames in real time; add "
                        "--clock wall",
                        scenario.display.kind, scenario.clock));
    auto opened = or_throw(scenario, window::Window::open(settings_of(scenario)));
    auto painter =
        or_throw(scenario, window::LensPainter::make(EyeMap(scenario.display.distortion)));
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
    record.hud_frames = hud_frames_;
}

}  // namespace foverig
