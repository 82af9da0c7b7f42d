#pragma once
// Static charts: shapes in a box of so many units, coloured by the page's style sheet, so that one
// drawing serves light and dark.
#include <string>
#include <string_view>
#include <vector>

namespace foverig::report {

struct Point {
    double x = 0.0;
    double y = 0.0;
};

class Svg {
  public:
    /// `label` says to those who cannot see it what the drawing shows.
    Svg(double width, double height, std::string_view label);

    /// `title` is shown on hovering; empty: none.
    Svg& rect(Point corner, double width, double height, std::string_view css_class,
              std::string_view title = {});
    Svg& line(Point from, Point to, std::string_view css_class);
    Svg& polyline(const std::vector<Point>& points, std::string_view css_class);
    Svg& circle(Point centre, double radius, std::string_view css_class,
                std::string_view title = {});
    /// `anchor`: start, middle or end.
    Svg& text(Point at, std::string_view text, std::string_view css_class,
              std::string_view anchor = "start");

    std::string str() const;

  private:
    std::string text_;
};

/// Maps values onto places, linearly.
struct Scale {
    double low = 0.0;
    double high = 1.0;
    double from = 0.0;
    double to = 1.0;

    double operator()(double value) const {
        return from + (value - low) / (high - low) * (to - from);
    }
};

/// Multiples of 1, 2 or 5 times a power of ten, from 0 to at most `high`; about `wanted` of them.
std::vector<double> ticks(double high, int wanted);

/// Style class of the i-th kind in a chart with several; the last one stands for all further ones.
std::string series_class(std::size_t i);
inline constexpr std::size_t kSeriesCount = 10;

}  // namespace foverig::report
