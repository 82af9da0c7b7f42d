#pragma once
#include <string_view>

#include "rig/report/svg.h"

namespace foverig::report {

/// Frame for charts of bars over frame numbers: milliseconds upwards, axes drawn. A bar stands for
/// one frame, or for several where there are more than can be drawn.
struct FrameChart {
    static constexpr double kWidth = 1000.0;
    static constexpr double kLeft = 52.0;
    static constexpr double kRight = kWidth - 12.0;

    FrameChart(std::string_view label, double height, double high_ms, std::size_t frames,
               std::size_t bars);

    double bar_left(std::size_t bar) const;

    Svg svg;
    Scale y;
    double pitch = 1.0;
    double bar_width = 1.0;
};

}  // namespace foverig::report
