#include "rig/live/open_window.h"

#include <fmt/format.h>

namespace foverig {
namespace {

window::Window::Settings settings_of(const Scenario& scenario, const std::string& title) {
    const int width_px = scenario.window.width_px;
    return {.title = title,
            .size = {width_px, width_px * 9 / 16},
            .full_screen = scenario.display.kind == "headset",
            .monitor = scenario.window.monitor,
            .rate_hz = scenario.display.rate_hz,
            .wait_vsync = scenario.window.wait_vsync};
}

}  // namespace

DeviceError window_failure(const Scenario& scenario, const Error& error) {
    const char* what_to_do = "update the graphics driver, or use --display virtual";
    if (error.code == ErrorCode::not_found)
        what_to_do = scenario.display.kind == "headset"
                         ? "foverig doctor says whether the headset is hidden from the desktop; "
                           "window.monitor names another one; or use --display window"
                         : "log in to a desktop (or set DISPLAY to one), or use --display virtual";
    return DeviceError(
        fmt::format("display.kind = {}: {}; {}", scenario.display.kind, error.text, what_to_do));
}

std::unique_ptr<window::Window> open_window(const Scenario& scenario, const std::string& title) {
    if (scenario.clock != "wall")
        throw UsageError(
            fmt::format("display.kind = {} and clock = {}: a window shows frames in real time; add "
                        "--clock wall",
                        scenario.display.kind, scenario.clock));
    return window_or_throw(scenario, window::Window::open(settings_of(scenario, title)));
}

}  // namespace foverig
