#include "rig/report/worst_frames.h"

#include <fmt/format.h>

#include <algorithm>

#include "rig/records/distribution.h"
#include "rig/report/markup.h"

namespace foverig::report {
namespace {

using Cells = std::vector<std::optional<double>>;

constexpr std::size_t kShown = 5;

struct Link {
    const char* from;
    const char* to;
};

/// As the table's columns: transport, age, render, lens, wait, scan-out.
constexpr Link kLinks[] = {{"sample_ns", "sample_arrival_ns"}, {"sample_arrival_ns", "begin_ns"},
                           {"begin_ns", "submit_ns"},          {"submit_ns", "present_ns"},
                           {"present_ns", "vsync_ns"},         {"vsync_ns", "photon_ns"}};

std::optional<double> median_of(const Cells& cells, std::size_t first) {
    std::vector<double> values;
    for (std::size_t i = first; i < cells.size(); ++i)
        if (cells[i]) values.push_back(*cells[i]);
    const auto spread = distribution_of(std::move(values));
    return spread ? std::optional(spread->p50) : std::nullopt;
}

std::vector<std::size_t> longest(const Cells& time_ms, std::size_t first) {
    std::vector<std::size_t> order;
    for (std::size_t i = first; i < time_ms.size(); ++i)
        if (time_ms[i]) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return *time_ms[a] > *time_ms[b]; });
    order.resize(std::min(order.size(), kShown));
    return order;
}

/// "trace_primary +3.1 ms"; of no passes a dash.
std::string blamed(const FrameTable& frames, std::size_t frame, std::size_t first) {
    std::string blamed = "–";
    double most_ms = 0.0;
    for (const std::string& id : frames.order) {
        if (!id.starts_with("pass.")) continue;
        const Cells& cells = frames.columns.at(id);
        const auto usual = median_of(cells, first);
        if (!cells[frame] || !usual || *cells[frame] - *usual <= most_ms) continue;
        most_ms = *cells[frame] - *usual;
        blamed = fmt::format("<code>{}</code> +{} ms", escaped(id.substr(5, id.size() - 8)),
                             number(most_ms));
    }
    return blamed;
}

/// "+0.3": signed, as it is told from another of the same row.
std::string above(const Cells& cells, std::size_t frame, std::size_t first) {
    const auto usual = median_of(cells, first);
    if (frame >= cells.size() || !cells[frame] || !usual) return "–";
    const double excess = *cells[frame] - *usual;
    return fmt::format("{}{}", excess < 0.0 ? "" : "+", number(excess));
}

const char* fate(const FrameTable& frames, std::size_t frame) {
    if (frames.column("dropped")[frame].value_or(0.0) > 0.0) return "dropped";
    return frames.column("late")[frame].value_or(0.0) > 0.0 ? "late" : "in time";
}

}  // namespace

std::string worst_frames(const RunData& run) {
    const FrameTable& frames = run.frames;
    const auto first = static_cast<std::size_t>(
        run.number({"steady_frame_time_ms", "warm_up_frames"}).value_or(0.0));
    const Cells time_ms = frames.column("frame_time_ms");
    const Cells cpu_ms = frames.column("cpu_ms");
    std::vector<std::vector<std::string>> rows;
    for (const std::size_t frame : longest(time_ms, first)) {
        std::vector<std::string> row{fmt::format("{}", frame), number(*time_ms[frame]),
                                     above(time_ms, frame, first), above(cpu_ms, frame, first),
                                     fate(frames, frame)};
        for (const Link& link : kLinks) {
            const auto from = frames.column(link.from)[frame];
            const auto to = frames.column(link.to)[frame];
            row.push_back(from && to ? number((*to - *from) * 1e-6) : "–");
        }
        row.push_back(number(frames.column("gaze_to_photon_ms")[frame]));
        row.push_back(blamed(frames, frame, first));
        rows.push_back(std::move(row));
    }
    if (rows.empty()) return "<p>No frame was rendered.</p>";
    return table({"frame", "ms", "above p50", "processor", "came", "transport", "age", "render",
                  "lens", "wait", "scan-out", "gaze's age", "furthest above its median"},
                 rows, {0, 1, 2, 3, 5, 6, 7, 8, 9, 10, 11});
}

}  // namespace foverig::report
