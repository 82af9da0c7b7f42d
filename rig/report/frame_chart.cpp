#include "rig/report/frame_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace foverig::report {
namespace {

constexpr double kTop = 18.0;
constexpr double kBottom = 34.0;

}  // namespace

FrameChart::FrameChart(std::string_view label, double height, double high_ms, std::size_t frames,
                       std::size_t bars)
    : svg(kWidth, height, label),
      y{0.0, high_ms, height - kBottom, kTop},
      pitch((kRight - kLeft) / static_cast<double>(bars)),
      bar_width(std::clamp(pitch * 0.82, 0.6, 28.0)) {
    for (const double tick : ticks(high_ms, 5)) {
        svg.line({kLeft, y(tick)}, {kRight, y(tick)}, "grid");
        svg.text({kLeft - 8, y(tick) + 4}, fmt::format("{:g}", tick), "axis", "end");
    }
    svg.text({kLeft - 8, kTop - 8}, "ms", "axis", "end");
    const double frame_pitch = (kRight - kLeft) / static_cast<double>(frames);
    for (const double tick : ticks(static_cast<double>(frames - 1), 10)) {
        if (tick != std::floor(tick)) continue;  // no half frames
        svg.text({kLeft + frame_pitch * (tick + 0.5), height - kBottom + 16},
                 fmt::format("{:g}", tick), "axis", "middle");
    }
    svg.text({(kLeft + kRight) / 2, height - 3}, "frame", "axis", "middle");
}

double FrameChart::bar_left(std::size_t bar) const {
    return kLeft + pitch * (static_cast<double>(bar) + 0.5) - bar_width / 2;
}

}  // namespace foverig::report
