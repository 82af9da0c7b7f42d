#include "rig/sweep/knob_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "rig/report/markup.h"
#include "rig/report/svg.h"
#include "rig/sweep/setting_text.h"

namespace foverig::sweep {
namespace {

using nlohmann::json;
using report::Point;
using report::Scale;
using report::Svg;

constexpr double kWidth = 1000.0, kHeight = 360.0;
constexpr double kLeft = 74.0, kRight = 976.0, kTop = 30.0, kBottom = 312.0;

struct Mark {
    double knob, error;
    json ci95;
    std::string title;
};

/// The settings of one line but for the knob, and its marks by the knob's value.
struct Line {
    json others;
    std::vector<Mark> marks;
};

std::vector<Line> lines_of(const json& pareto, const std::string& knob) {
    const auto axis = pareto.at("error").get<std::string>();
    std::vector<Line> lines;
    for (const json& point : pareto.at("points")) {
        json others = point.at("settings");
        others.erase(knob);
        const json& error = point.at("error").at(axis);
        auto line = std::find_if(lines.begin(), lines.end(),
                                 [&](const Line& l) { return l.others == others; });
        if (line == lines.end()) line = lines.insert(lines.end(), Line{others, {}});
        line->marks.push_back({point.at("settings").at(knob).get<double>(),
                               error.at("mean").get<double>(), error.at("ci95"),
                               fmt::format("{}: error {:.4g}", setting_text(point.at("settings")),
                                           error.at("mean").get<double>())});
    }
    for (Line& line : lines)
        std::sort(line.marks.begin(), line.marks.end(),
                  [](const Mark& a, const Mark& b) { return a.knob < b.knob; });
    return lines;
}

void draw_line(Svg& svg, const Line& line, const Scale& x, const Scale& y, std::size_t number) {
    const std::string series = report::series_class(number);
    std::vector<Point> places;
    for (const Mark& mark : line.marks) places.push_back({x(mark.knob), y(mark.error)});
    svg.polyline(places, "line " + series);
    for (const Mark& mark : line.marks) {
        const double at = x(mark.knob);
        if (mark.ci95.is_array())
            svg.line({at, y(std::max(0.0, mark.ci95.at(0).get<double>()))},
                     {at, y(std::min(y.high, mark.ci95.at(1).get<double>()))}, "interval");
        svg.circle({at, y(mark.error)}, 4.0, series, mark.title);
    }
}

std::string legend(const std::vector<Line>& lines) {
    std::string html = "<div class=\"legend\">";
    for (std::size_t i = 0; i < lines.size(); ++i)
        html += fmt::format("<span><i class=\"{}\"></i>{}</span>", report::series_class(i),
                            report::escaped(setting_text(lines[i].others)));
    return html + "<span>upright lines: 95 % intervals over blocks of frames</span></div>";
}

std::string chart(const json& pareto, const std::string& knob) {
    const std::vector<Line> lines = lines_of(pareto, knob);
    double most_knob = 0.0;
    double most_error = 1e-9;
    for (const Line& line : lines)
        for (const Mark& mark : line.marks) {
            most_knob = std::max(most_knob, mark.knob);
            most_error = std::max(most_error, mark.error);
        }
    const Scale x{0.0, most_knob > 0.0 ? 1.03 * most_knob : 1.0, kLeft, kRight};
    const Scale y{0.0, 1.2 * most_error, kBottom, kTop};
    Svg svg(kWidth, kHeight, "error over " + knob);
    for (const double tick : report::ticks(x.high, 10)) {
        svg.line({x(tick), kTop}, {x(tick), kBottom}, "grid");
        svg.text({x(tick), kBottom + 18}, fmt::format("{:g}", tick), "axis", "middle");
    }
    for (const double tick : report::ticks(y.high, 6)) {
        svg.line({kLeft, y(tick)}, {kRight, y(tick)}, "grid");
        svg.text({kLeft - 8, y(tick) + 4}, fmt::format("{:g}", tick), "axis", "end");
    }
    svg.text({(kLeft + kRight) / 2, kHeight - 10}, knob, "axis", "middle");
    svg.text({kLeft - 8, kTop - 12}, "error: " + pareto.at("error").get<std::string>(), "axis");
    for (std::size_t i = 0; i < lines.size(); ++i) draw_line(svg, lines[i], x, y, i);
    return svg.str() + (lines.size() > 1 ? legend(lines) : "");
}

}  // namespace

std::string knob_charts(const json& pareto) {
    std::string html;
    for (const json& knob : pareto.at("sweep").value("over", json::array()))
        html += chart(pareto, knob.get<std::string>());
    return html;
}

}  // namespace foverig::sweep
