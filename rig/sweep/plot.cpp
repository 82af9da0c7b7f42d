#include "rig/sweep/plot.h"

#include <fmt/format.h>

#include <algorithm>

#include "rig/sweep/error_chart.h"
#include "rig/sweep/setting_text.h"

namespace foverig::sweep {
namespace {

using nlohmann::json;
using report::Point;

constexpr double kHeight = 520.0;

struct Mark : ErrorMark {
    bool on_front, is_default;
};

std::vector<Mark> marks_of(const json& pareto) {
    const auto axis = pareto.at("error").get<std::string>();
    std::vector<Mark> marks;
    for (const json& point : pareto.at("points")) {
        const json& time = point.at("time_ms");
        const json& error = point.at("error").at(axis);
        marks.push_back(
            {{time.at("value").get<double>(), error.at("mean").get<double>(), time.at("ci95"),
              error.at("ci95"),
              fmt::format("point {}: {}: {:.4g} ms, error {:.4g}", point.at("point").get<int>(),
                          point.contains("variant") ? point.at("variant").get<std::string>()
                                                    : setting_text(point.at("settings")),
                          time.at("value").get<double>(), error.at("mean").get<double>())},
             point.at("on_front").get<bool>(),
             point.at("default").get<bool>()});
    }
    return marks;
}

double high_of(double value, const json& ci95) {
    return ci95.is_null() ? value : std::max(value, ci95.at(1).get<double>());
}

/// The error that a budget buys: nothing better until the next point of the front.
void draw_front(ErrorChart& chart, const json& front) {
    std::vector<Point> steps;
    for (const json& place : front) {
        const double at = chart.x(place.at("time_ms").get<double>());
        if (!steps.empty()) steps.push_back({at, steps.back().y});
        steps.push_back({at, chart.y(place.at("error").get<double>())});
    }
    if (!steps.empty()) steps.push_back({ErrorChart::kRight, steps.back().y});
    chart.svg.polyline(steps, "front");
}

void draw_vsync(ErrorChart& chart, double budget_ms) {
    const double at = chart.x(budget_ms);
    chart.svg.line({at, ErrorChart::kTop}, {at, chart.bottom()}, "budget");
    const bool left_of_it = at > (ErrorChart::kLeft + ErrorChart::kRight) / 2;
    chart.svg.text({at + (left_of_it ? -6.0 : 6.0), ErrorChart::kTop + 14},
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
        most_ms = std::max({most_ms, mark.across,
                            std::min(high_of(mark.across, mark.across_ci95), 1.5 * mark.across)});
        most_error = std::max({most_error, mark.error,
                               std::min(high_of(mark.error, mark.error_ci95), 1.5 * mark.error)});
    }
    ErrorChart chart("error against milliseconds a frame, one mark a setting", kHeight,
                     1.04 * most_ms, "milliseconds a frame", 1.06 * most_error,
                     pareto.at("error").get<std::string>());
    draw_vsync(chart, budget_ms);
    draw_front(chart, pareto.at("front"));
    for (const Mark& mark : marks) chart.draw_intervals(mark);
    for (const Mark& mark : marks)
        chart.svg.circle(chart.place(mark), mark.on_front ? 5.0 : 3.5,
                         mark.on_front ? "on-front" : "behind", mark.title);
    for (const Mark& mark : marks) {
        if (!mark.is_default) continue;
        const Point at = chart.place(mark);
        chart.svg.circle(at, 10.0, "default-ring", mark.title);
        // Below and to the left of a front nothing lies.
        const double below = at.y + 22.0 < chart.bottom() ? at.y + 20.0 : at.y - 12.0;
        chart.svg.text({at.x - 11, below}, "default", "mark-name", "end");
    }
    return chart.svg.str();
}

}  // namespace foverig::sweep
