#include "devices/window/monitors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "devices/window/glfw.h"

namespace foverig::window {
namespace {

constexpr double kLong_mm = 125.76, kShort_mm = 70.74;
constexpr double kSizeTolerance = 0.15;

bool near_to(double value, double expected) {
    return std::abs(value / expected - 1.0) <= kSizeTolerance;
}

bool is_dk2(const Monitor& monitor) {
    const auto [short_px, long_px] = std::minmax(monitor.mode.width, monitor.mode.height);
    if (short_px != 1080 || long_px != 1920) return false;
    if (monitor.name.find("Rift") != std::string::npos) return true;
    const auto [short_mm, long_mm] = std::minmax(monitor.width_mm, monitor.height_mm);
    return near_to(short_mm, kShort_mm) && near_to(long_mm, kLong_mm);
}

}  // namespace

std::string text_of(const Monitor& monitor) {
    return fmt::format("{} ({}x{}{}, {}x{} mm)", monitor.name, monitor.mode.width,
                       monitor.mode.height,
                       monitor.refresh_hz > 0 ? fmt::format(" at {} Hz", monitor.refresh_hz) : "",
                       monitor.width_mm, monitor.height_mm);
}

std::optional<std::size_t> dk2_among(std::span<const Monitor> monitors) {
    const auto found = std::find_if(monitors.begin(), monitors.end(), is_dk2);
    if (found == monitors.end()) return std::nullopt;
    return static_cast<std::size_t>(found - monitors.begin());
}

Result<std::size_t> choose_monitor(std::span<const Monitor> monitors, const std::string& name) {
    if (name.empty()) {
        if (const auto dk2 = dk2_among(monitors)) return *dk2;
    }
    std::string all;
    for (std::size_t i = 0; i < monitors.size(); ++i) {
        if (!name.empty() && monitors[i].name == name) return i;
        all += (i == 0 ? "" : ", ") + text_of(monitors[i]);
    }
    const std::string wanted =
        name.empty() ? "no monitor looks like a DK2's panel" : "there is no monitor " + name;
    return Error{ErrorCode::not_found,
                 fmt::format("{} among {}", wanted, all.empty() ? "none at all" : all)};
}

Result<std::vector<Monitor>> list_monitors() {
    Result<Glfw> glfw = Glfw::open();
    if (!glfw) return glfw.error();
    std::vector<Monitor> monitors;
    for (GLFWmonitor* monitor : glfw->monitors()) monitors.push_back(facts_of(monitor));
    return monitors;
}

}  // namespace foverig::window
