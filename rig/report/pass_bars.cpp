#include "rig/report/pass_bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "rig/report/frame_chart.h"
#include "rig/report/markup.h"
#include "rig/report/svg.h"

namespace foverig::report {
namespace {

constexpr double kWidth = 1000.0;
constexpr double kHeight = 220.0;
constexpr std::size_t kMostColumns = 160;

struct Pass {
    std::string name;
    double mean_ms = 0.0;  ///< a frame, over all frames
};

/// Longest first. A pass that ran in some frames only counts as 0 in the others.
std::vector<Pass> passes_of(const RunData& run) {
    std::vector<Pass> passes;
    if (!run.summary.contains("pass_time_ms")) return passes;
    const double frames = run.number({"frames", "rendered"}).value_or(0.0);
    for (const auto& [name, spread] : run.summary["pass_time_ms"].items()) {
        if (!spread.is_object() || frames == 0.0) continue;
        passes.push_back({name, spread["mean"].get<double>() * spread["n"].get<double>() / frames});
    }
    std::stable_sort(passes.begin(), passes.end(),
                     [](const Pass& a, const Pass& b) { return a.mean_ms > b.mean_ms; });
    return passes;
}

std::string mean_bar(const std::vector<Pass>& passes, double total_ms) {
    Svg svg(kWidth, 40.0, "Mean time of each pass as shares of the frame");
    double x = 0.0;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const double width = passes[i].mean_ms / total_ms * kWidth;
        svg.rect({x, 4.0}, width, 32.0, series_class(i),
                 fmt::format("{}: {} ms, {}", passes[i].name, number(passes[i].mean_ms),
                             percent(passes[i].mean_ms / total_ms)));
        if (width > 8.0 * static_cast<double>(passes[i].name.size())) {
            svg.text({x + width / 2, 24.0}, passes[i].name, "on-bar", "middle");
        }
        x += width;
    }
    return svg.str();
}

/// Mean of the cells of one column from `first` up to `last`; what is absent is 0.
double mean_of(const std::vector<std::optional<double>>& cells, std::size_t first,
               std::size_t last) {
    double sum = 0.0;
    for (std::size_t i = first; i < last; ++i) sum += cells[i].value_or(0.0);
    return sum / static_cast<double>(last - first);
}

std::string per_frame(const RunData& run, const std::vector<Pass>& passes) {
    const std::size_t frames = run.frames.frames;
    if (frames == 0 || run.frames.columns.count("render_ms") == 0) return "";
    const std::size_t per_column = (frames + kMostColumns - 1) / kMostColumns;
    std::vector<std::vector<std::optional<double>>> cells;
    for (const Pass& pass : passes) cells.push_back(run.frames.column("pass." + pass.name + "_ms"));
    std::vector<std::vector<double>> stacks;
    double high_ms = 0.0;
    for (std::size_t first = 0; first < frames; first += per_column) {
        const std::size_t last = std::min(first + per_column, frames);
        std::vector<double>& stack = stacks.emplace_back();
        for (const auto& pass : cells) stack.push_back(mean_of(pass, first, last));
        high_ms = std::max(high_ms, std::accumulate(stack.begin(), stack.end(), 0.0));
    }
    if (high_ms == 0.0) return "";
    FrameChart chart("Passes of every frame, stacked", kHeight, high_ms * 1.08, frames,
                     stacks.size());
    for (std::size_t column = 0; column < stacks.size(); ++column) {
        double bottom_ms = 0.0;
        for (std::size_t i = 0; i < passes.size(); ++i) {
            const double ms = stacks[column][i];
            chart.svg.rect({chart.bar_left(column), chart.y(bottom_ms + ms)}, chart.bar_width,
                           chart.y(bottom_ms) - chart.y(bottom_ms + ms), series_class(i));
            bottom_ms += ms;
        }
    }
    return chart.svg.str();
}

std::string pass_table(const RunData& run, const std::vector<Pass>& passes, double total_ms) {
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const char* name = passes[i].name.c_str();
        rows.push_back({fmt::format("<i class=\"key {}\"></i><code>{}</code>", series_class(i),
                                    escaped(passes[i].name)),
                        number(passes[i].mean_ms), percent(passes[i].mean_ms / total_ms),
                        number(run.number({"pass_time_ms", name, "p50"})),
                        number(run.number({"pass_time_ms", name, "p99"})),
                        count(run.number({"pass_time_ms", name, "n"}))});
    }
    return table({"pass", "mean ms a frame", "share", "p50 ms", "p99 ms", "frames"}, rows,
                 {1, 2, 3, 4, 5});
}

}  // namespace

std::string pass_bars(const RunData& run) {
    const auto passes = passes_of(run);
    double total_ms = 0.0;
    for (const Pass& pass : passes) total_ms += pass.mean_ms;
    if (total_ms == 0.0) return "<p>No pass was timed.</p>";
    return mean_bar(passes, total_ms) + per_frame(run, passes) + pass_table(run, passes, total_ms);
}

}  // namespace foverig::report
