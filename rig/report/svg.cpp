#include "rig/report/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rig/report/markup.h"

namespace foverig::report {
namespace {

std::string titled(std::string_view element, std::string_view title) {
    if (title.empty()) return fmt::format("<{}/>", element);
    const auto name = element.substr(0, element.find(' '));
    return fmt::format("<{}><title>{}</title></{}>", element, escaped(title), name);
}

}  // namespace

Svg::Svg(double width, double height, std::string_view label)
    : text_(fmt::format("<svg viewBox=\"0 0 {:.4g} {:.4g}\" role=\"img\" aria-label=\"{}\">", width,
                        height, escaped(label))) {}

Svg& Svg::rect(Point corner, double width, double height, std::string_view css_class,
               std::string_view title) {
    text_ += titled(
        fmt::format("rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
                    "class=\"{}\"",
                    corner.x, corner.y, std::max(width, 0.0), std::max(height, 0.0), css_class),
        title);
    return *this;
}

Svg& Svg::line(Point from, Point to, std::string_view css_class) {
    text_ +=
        fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" class=\"{}\"/>",
                    from.x, from.y, to.x, to.y, css_class);
    return *this;
}

Svg& Svg::polyline(const std::vector<Point>& points, std::string_view css_class) {
    text_ += fmt::format("<polyline class=\"{}\" points=\"", css_class);
    for (const Point& point : points) text_ += fmt::format("{:.2f},{:.2f} ", point.x, point.y);
    text_ += "\"/>";
    return *this;
}

Svg& Svg::circle(Point centre, double radius, std::string_view css_class, std::string_view title) {
    text_ += titled(fmt::format("circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" class=\"{}\"",
                                centre.x, centre.y, radius, css_class),
                    title);
    return *this;
}

Svg& Svg::text(Point at, std::string_view text, std::string_view css_class,
               std::string_view anchor) {
    text_ +=
        fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" class=\"{}\" text-anchor=\"{}\">{}</text>",
                    at.x, at.y, css_class, anchor, escaped(text));
    return *this;
}

std::string Svg::str() const {
    return "<div class=\"scroll\">" + text_ + "</svg></div>";
}

std::vector<double> ticks(double high, int wanted) {
    if (!(high > 0.0) || wanted < 1) return {0.0};
    const double raw = high / wanted;
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    double step = 10.0 * power;
    for (const double multiple : {1.0, 2.0, 5.0}) {
        if (multiple * power >= raw) {
            step = multiple * power;
            break;
        }
    }
    std::vector<double> places;
    for (int i = 0; i * step <= high * (1.0 + 1e-9); ++i) places.push_back(i * step);
    return places;
}

std::string series_class(std::size_t i) {
    return fmt::format("s{}", std::min(i, kSeriesCount - 1));
}

}  // namespace foverig::report
