#include "rig/sweep/error_chart.h"

#include <fmt/format.h>

#include <algorithm>

namespace foverig::sweep {
namespace {

using report::Scale;
using report::Svg;

constexpr double kCap = 4.0;  // half the end of an interval's line
constexpr int kTicksAcross = 10;
constexpr double kBetweenTicks = 54.0;  // upwards, about

}  // namespace

ErrorChart::ErrorChart(const std::string& label, double height, double most_across,
                       const std::string& across, double most_error, const std::string& error)
    : svg(kWidth, height, label),
      x{0.0, most_across, kLeft, kRight},
      y{0.0, most_error, height - kBelow, kTop} {
    for (const double tick : report::ticks(x.high, kTicksAcross)) {
        svg.line({x(tick), kTop}, {x(tick), bottom()}, "grid");
        svg.text({x(tick), bottom() + 18}, fmt::format("{:g}", tick), "axis", "middle");
    }
    for (const double tick :
         report::ticks(y.high, static_cast<int>((bottom() - kTop) / kBetweenTicks))) {
        svg.line({kLeft, y(tick)}, {kRight, y(tick)}, "grid");
        svg.text({kLeft - 8, y(tick) + 4}, fmt::format("{:g}", tick), "axis", "end");
    }
    svg.text({(kLeft + kRight) / 2, height - 12}, across, "axis", "middle");
    svg.text({kLeft - 8, kTop - 12}, "error: " + error, "axis");
}

void ErrorChart::draw_intervals(const ErrorMark& mark) {
    const report::Point at = place(mark);
    if (mark.across_ci95.is_array()) {
        const double low = x(std::max(x.low, mark.across_ci95.at(0).get<double>()));
        const double high = x(std::min(x.high, mark.across_ci95.at(1).get<double>()));
        svg.line({low, at.y}, {high, at.y}, "interval");
        svg.line({low, at.y - kCap}, {low, at.y + kCap}, "interval");
        svg.line({high, at.y - kCap}, {high, at.y + kCap}, "interval");
    }
    if (mark.error_ci95.is_array())
        draw_upright_interval(svg, at.x, y, mark.error_ci95.at(0).get<double>(),
                              mark.error_ci95.at(1).get<double>(), "interval");
}

void draw_upright_interval(Svg& svg, double at_x, const Scale& y, double low, double high,
                           const char* css_class) {
    const double bottom = y(std::max(y.low, low));
    const double top = y(std::min(y.high, high));
    svg.line({at_x, bottom}, {at_x, top}, css_class);
    svg.line({at_x - kCap, bottom}, {at_x + kCap, bottom}, css_class);
    svg.line({at_x - kCap, top}, {at_x + kCap, top}, css_class);
}

}  // namespace foverig::sweep
