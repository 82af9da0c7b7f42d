#pragma once
// What the charts of a sweep have in common: an error upwards, something from 0 across, and marks
// with intervals.
#include <nlohmann/json.hpp>
#include <string>

#include "rig/report/svg.h"

namespace foverig::sweep {

/// A place on such a chart; the intervals are [low, high] or null.
struct ErrorMark {
    double across = 0.0;
    double error = 0.0;
    nlohmann::json across_ci95, error_ci95;
    std::string title;
};

struct ErrorChart {
    static constexpr double kWidth = 1000.0;
    static constexpr double kLeft = 74.0, kRight = 976.0, kTop = 30.0;
    static constexpr double kBelow = 54.0;  ///< of the height, for the numbers and the name below

    /// Axes, grid and names are drawn. `label` is the drawing's, for those who cannot see it.
    ErrorChart(const std::string& label, double height, double most_across,
               const std::string& across, double most_error, const std::string& error);

    double bottom() const { return y.from; }
    report::Point place(const ErrorMark& mark) const { return {x(mark.across), y(mark.error)}; }
    /// Its intervals, as far as the chart reaches.
    void draw_intervals(const ErrorMark& mark);

    report::Svg svg;
    report::Scale x, y;
};

/// An upright interval with caps at that place across, cut off at both ends of the scale.
void draw_upright_interval(report::Svg& svg, double at_x, const report::Scale& y, double low,
                           double high, const char* css_class);

}  // namespace foverig::sweep
