#include "rig/report/frame_strip.h"

#include <fmt/format.h>

#include <algorithm>

#include "rig/report/frame_chart.h"
#include "rig/report/markup.h"

namespace foverig::report {
namespace {

constexpr double kHeight = 250.0;
constexpr std::size_t kMostBars = 400;

/// A run of frames that share one bar: one frame each, or more where there are too many to draw.
struct Bar {
    std::size_t first = 0;
    std::size_t last = 0;
    double most_ms = 0.0;
    bool late = false;
    bool dropped = false;
    bool warm_up = false;  ///< left out of the steady numbers, all of it
};

std::vector<Bar> bars_of(const FrameTable& frames, std::size_t warm_up_frames) {
    const auto time_ms = frames.column("frame_time_ms");
    const auto late = frames.column("late");
    const auto dropped = frames.column("dropped");
    const std::size_t per_bar = (frames.frames + kMostBars - 1) / kMostBars;
    std::vector<Bar> bars;
    for (std::size_t i = 0; i < frames.frames; ++i) {
        if (i % per_bar == 0) bars.push_back({.first = i});
        Bar& bar = bars.back();
        bar.last = i;
        bar.warm_up = i < warm_up_frames;
        bar.most_ms = std::max(bar.most_ms, time_ms[i].value_or(0.0));
        bar.late = bar.late || late[i].value_or(0.0) > 0.0;
        bar.dropped = bar.dropped || dropped[i].value_or(0.0) > 0.0;
    }
    return bars;
}

std::string bar_title(const Bar& bar) {
    const std::string which = bar.first == bar.last
                                  ? fmt::format("frame {}", bar.first)
                                  : fmt::format("frames {} to {}, most", bar.first, bar.last);
    const char* fate = bar.dropped ? ", dropped" : bar.late ? ", late" : "";
    return fmt::format("{}: {} ms{}{}", which, number(bar.most_ms), fate,
                       bar.warm_up ? ", warm-up" : "");
}

}  // namespace

std::string frame_strip(const RunData& run) {
    const auto warm_up_frames = static_cast<std::size_t>(
        run.number({"steady_frame_time_ms", "warm_up_frames"}).value_or(0.0));
    const auto bars = bars_of(run.frames, warm_up_frames);
    if (bars.empty()) return "<p>No frame was rendered.</p>";
    const double budget_ms = run.number({"vsync", "budget_ms"}).value_or(0.0);
    double high_ms = budget_ms;
    for (const Bar& bar : bars) high_ms = std::max(high_ms, bar.most_ms);
    high_ms *= 1.08;

    FrameChart chart("Time of every frame beside the VSync budget", kHeight, high_ms,
                     run.frames.frames, bars.size());
    Svg& svg = chart.svg;
    const Scale& y = chart.y;
    const double width = chart.bar_width;
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const double x = chart.bar_left(i);
        const char* look = bars[i].warm_up   ? "s9"
                           : bars[i].dropped ? "dropped"
                           : bars[i].late    ? "late"
                                             : "good";
        svg.rect({x, y(bars[i].most_ms)}, width, y(0.0) - y(bars[i].most_ms), look,
                 bar_title(bars[i]));
    }
    svg.line({FrameChart::kLeft, y(budget_ms)}, {FrameChart::kRight, y(budget_ms)}, "budget");
    svg.text({FrameChart::kRight - 4, y(budget_ms) - 5},
             fmt::format("VSync budget {} ms", number(budget_ms)), "budget-text", "end");
    return svg.str() +
           "<p class=\"legend\"><span><i class=\"good\"></i>in time</span><span><i "
           "class=\"late\"></i>late: missed the VSync it was begun for</span><span><i "
           "class=\"dropped\"></i>dropped: never shown</span>" +
           (warm_up_frames > 0 ? "<span><i class=\"s9\"></i>warm-up: kept, but out of the steady "
                                 "numbers</span></p>"
                               : "</p>");
}

}  // namespace foverig::report
