#include "rig/sweep/knob_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "rig/report/markup.h"
#include "rig/sweep/error_chart.h"
#include "rig/sweep/setting_text.h"

namespace foverig::sweep {
namespace {

using nlohmann::json;

constexpr double kHeight = 360.0;

/// The settings of one line but for the knob, and its marks by the knob's value.
struct Line {
    json others;
    std::vector<ErrorMark> marks;
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
                               error.at("mean").get<double>(), nullptr, error.at("ci95"),
                               fmt::format("{}: error {:.4g}", setting_text(point.at("settings")),
                                           error.at("mean").get<double>())});
    }
    for (Line& line : lines)
        std::sort(line.marks.begin(), line.marks.end(),
                  [](const ErrorMark& a, const ErrorMark& b) { return a.across < b.across; });
    return lines;
}

void draw_line(ErrorChart& chart, const Line& line, std::size_t number) {
    const std::string series = report::series_class(number);
    std::vector<report::Point> places;
    for (const ErrorMark& mark : line.marks) places.push_back(chart.place(mark));
    chart.svg.polyline(places, "line " + series);
    for (const ErrorMark& mark : line.marks) {
        chart.draw_intervals(mark);
        chart.svg.circle(chart.place(mark), 4.0, series, mark.title);
    }
}

std::string legend(const std::vector<Line>& lines) {
    std::string html = "<div class=\"legend\">";
    for (std::size_t i = 0; i < lines.size(); ++i)
        html += fmt::format("<span><i class=\"{}\"></i>{}</span>", report::series_class(i),
                            report::escaped(setting_text(lines[i].others)));
    return html + "<span>upright lines: 95 % intervals over blocks of frames</span></div>";
}

std::string chart_of(const json& pareto, const std::string& knob) {
    const std::vector<Line> lines = lines_of(pareto, knob);
    double most_knob = 0.0;
    double most_error = 1e-9;
    for (const Line& line : lines)
        for (const ErrorMark& mark : line.marks) {
            most_knob = std::max(most_knob, mark.across);
            most_error = std::max(most_error, mark.error);
        }
    ErrorChart chart("error over " + knob, kHeight, most_knob > 0.0 ? 1.03 * most_knob : 1.0, knob,
                     1.2 * most_error, pareto.at("error").get<std::string>());
    for (std::size_t i = 0; i < lines.size(); ++i) draw_line(chart, lines[i], i);
    return chart.svg.str() + (lines.size() > 1 ? legend(lines) : "");
}

}  // namespace

std::string knob_charts(const json& pareto) {
    std::string html;
    for (const json& knob : pareto.at("sweep").value("over", json::array()))
        html += chart_of(pareto, knob.get<std::string>());
    return html;
}

}  // namespace foverig::sweep
