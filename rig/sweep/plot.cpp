#include "rig/sweep/plot.h"

#include <fmt/format.h>

#include <algorithm>

#include "rig/report/svg.h"
#include "rig/sweep/setting_text.h"

namespace foverig::sweep {
namespace {

using nlohmann::json;
using report::Point;
using report::Scale;
using report::Svg;

constexpr double kWidth = 1000.0, kHeight = 520.0;
constexpr double kLeft = 74.0, kRight = 976.0, kTop = 30.0, kBottom = 466.0;
constexpr double kCap = 4.0;  // half the end of an interval's line

struct Mark {
    double ms, error;
    json ms_ci95, error_ci95;
    bool on_front, is_default;
    std::string title;
};

std::vector<Mark> marks_of(const json& pareto) {
    const auto axis = pareto.at("error").get<std::string>();
    std::vector<Mark> marks;
    for (const json& point : pareto.at("points")) {
        const json& time = point.at("time_ms");
        const json& error = point.at("error").at(axis);
        marks.push_back(
            {time.at("value").get<double>(), error.at("mean").get<double>(), time.at("ci95"),
             error.at("ci95"), point.at("on_front").get<bool>(), point.at("default").get<bool>(),
             fmt::format("point {}: {}: {:.4g} ms, error {:.4g}", point.at("point").get<int>(),
                         point.contains("variant") ? point.at("variant").get<std::string>()
                                                   : setting_text(point.at("settings")),
                         time.at("value").get<double>(), error.at("mean").get<double>())});
    }
    return marks;
}

double high_of(double value, const json& ci95) {
    return ci95.is_null() ? value : std::max(value, ci95.at(1).get<double>());
}

void draw_axes(Svg& svg, const Scale& x, const Scale& y, const std::string& error) {
    for (const double tick : report::ticks(x.high, 10)) {
        svg.line({x(tick), kTop}, {x(tick), kBottom}, "grid");
        svg.text({x(tick), kBottom + 18}, fmt::format("{:g}", tick), "axis", "middle");
    }
    for (const double tick : report::ticks(y.high, 8)) {
        svg.line({kLeft, y(tick)}, {kRight, y(tick)}, "grid");
        svg.text({kLeft - 8, y(tick) + 4}, fmt::format("{:g}", tick), "axis", "end");
    }
    svg.text({(kLeft + kRight) / 2, kHeight - 12}, "milliseconds a frame", "axis", "middle");
    svg.text({kLeft - 8, kTop - 12}, fmt::format("error: {}", error), "axis", "start");
}

/// The error that a budget buys: nothing better until the next point of the front.
void draw_front(Svg& svg, const Scale& x, const Scale& y, const json& front) {
    std::vector<Point> steps;
    for (const json& place : front) {
        const double at = x(place.at("time_ms").get<double>());
        if (!steps.empty()) steps.push_back({at, steps.back().y});
        steps.push_back({at, y(place.at("error").get<double>())});
    }
    if (!steps.empty()) steps.push_back({kRight, steps.back().y});
    svg.polyline(steps, "front");
}

void draw_intervals(Svg& svg, const Scale& x, const Scale& y, const Mark& mark) {
    const double at_x = x(mark.ms);
    const double at_y = y(mark.error);
    if (!mark.ms_ci95.is_null()) {
        const double low = x(std::max(0.0, mark.ms_ci95.at(0).get<double>()));
        const double high = std::min(kRight, x(mark.ms_ci95.at(1).get<double>()));
        svg.line({low, at_y}, {high, at_y}, "interval");
        svg.line({low, at_y - kCap}, {low, at_y + kCap}, "interval");
        svg.line({high, at_y - kCap}, {high, at_y + kCap}, "interval");
    }
    if (!mark.error_ci95.is_null()) {
        const double low = y(std::max(0.0, mark.error_ci95.at(0).get<double>()));
        const double high = std::max(kTop, y(mark.error_ci95.at(1).get<double>()));
        svg.line({at_x, low}, {at_x, high}, "interval");
        svg.line({at_x - kCap, low}, {at_x + kCap, low}, "interval");
        svg.line({at_x - kCap, high}, {at_x + kCap, high}, "interval");
    }
}

void draw_vsync(Svg& svg, const Scale& x, double budget_ms) {
    svg.line({x(budget_ms), kTop}, {x(budget_ms), kBottom}, "budget");
    const bool left_of_it = x(budget_ms) > (kLeft + kRight) / 2;
    svg.text({x(budget_ms) + (left_of_it ? -6.0 : 6.0), kTop + 14},
             fmt::format("VSync, {:.3g} ms", budget_ms), "budget-text",
             left_of_it ? "end" : "start");
}

}  // namespace

std::string plot(const json& pareto) {
    const std::vector<Mark> marks = marks_of(pareto);
    const double budget_ms = pareto.at("budget_ms").get<double>();
    // Intervals may reach beyond the picture; places may not.
    double most_ms = budget_ms;
    double most_error = 1e-9;
    for (const Mark& mark : marks) {
        most_ms =
            std::max({most_ms, mark.ms, std::min(high_of(mark.ms, mark.ms_ci95), 1.5 * mark.ms)});
        most_error = std::max({most_error, mark.error,
                               std::min(high_of(mark.error, mark.error_ci95), 1.5 * mark.error)});
    }
    const Scale x{0.0, 1.04 * most_ms, kLeft, kRight};
    const Scale y{0.0, 1.06 * most_error, kBottom, kTop};
    Svg svg(kWidth, kHeight, "error against milliseconds a frame, one mark a setting");
    draw_axes(svg, x, y, pareto.at("error").get<std::string>());
    draw_vsync(svg, x, budget_ms);
    draw_front(svg, x, y, pareto.at("front"));
    for (const Mark& mark : marks) draw_intervals(svg, x, y, mark);
    for (const Mark& mark : marks)
        svg.circle({x(mark.ms), y(mark.error)}, mark.on_front ? 5.0 : 3.5,
                   mark.on_front ? "on-front" : "behind", mark.title);
    for (const Mark& mark : marks) {
        if (!mark.is_default) continue;
        svg.circle({x(mark.ms), y(mark.error)}, 10.0, "default-ring", mark.title);
        svg.text({x(mark.ms) + 13, y(mark.error) - 9}, "default", "axis-strong");
    }
    return svg.str();
}

}  // namespace foverig::sweep
