#include "rig/report/page.h"

#include <fmt/format.h>

#include "rig/records/columns.h"
#include "rig/report/facts.h"
#include "rig/report/frame_strip.h"
#include "rig/report/gallery.h"
#include "rig/report/governor_chart.h"
#include "rig/report/latency_chain.h"
#include "rig/report/latency_phases.h"
#include "rig/report/live_strip.h"
#include "rig/report/markup.h"
#include "rig/report/overview.h"
#include "rig/report/pass_bars.h"
#include "rig/report/scripts.h"
#include "rig/report/style.h"
#include "rig/report/worst_frames.h"

namespace foverig::report {
namespace {

constexpr std::size_t kMostGalleryBytes = 5'000'000;  // of a page that stays below 6 MB

std::string column_listing() {
    std::vector<std::vector<std::string>> rows;
    for (const Column& column : frame_columns()) {
        rows.push_back({"<code>" + escaped(column.id) + "</code>", escaped(column.unit),
                        escaped(column.definition)});
    }
    return "<details><summary>Columns of frames.csv</summary>" +
           table({"column", "unit", "definition"}, rows) + "</details>";
}

/// The resolved scenario holds every key, so it alone is the run.
std::string repeating(const RunData& run) {
    const bool exactly = run.summary.value("fixed_cost", false);
    return fmt::format(
        "<p>To repeat this run, in this folder: <code>foverig run scenario.toml --out "
        "again</code>. "
        "{}</p>",
        exactly ? "Cost is fixed, so frames.csv and the images come out bit for bit."
                : "Times are measured, so they differ; `foverig compare . again` says whether by "
                  "more than chance.");
}

}  // namespace

std::string page(const RunData& run) {
    std::string html = page_head("foverig · " + title(run), kStyle);
    html += overview(run);
    html += section("Frame times",
                    "Work of each frame, from its begin to its hand-over to the "
                    "display, without waiting.",
                    "<div>" + frame_strip(run) + live_strip(run) + "</div>");
    if (const std::string chart = governor_chart(run); !chart.empty())
        html += section("What the governor chose",
                        "Setting by setting, the cheapest is 0. Costs and errors are those of the "
                        "sweep that measured them.",
                        chart);
    html += section("Where the time goes",
                    "Wall time of the renderer's passes: means above, then "
                    "frame by frame.",
                    pass_bars(run));
    html += section("Latency, link by link",
                    "From the instant a sensor took its sample to the "
                    "light of the frame that used it, mid-panel. Means add up; only frames that "
                    "were shown count.",
                    latency_chain(run));
    if (const std::string phases = latency_phases(run); !phases.empty())
        html += section("Latency by phase of motion", "", phases);
    html += section("The worst frames, link by link",
                    "The longest beyond the warm-up, in milliseconds: from the inertial sample to "
                    "the light, how old the gaze was then, and the pass that lies furthest above "
                    "what it usually takes. Processor: its time above the p50 of that; where it is "
                    "far less than the frame's own, the frame waited for a processor that others "
                    "had.",
                    worst_frames(run));
    html += section("What was rendered, and why",
                    "The effect plan: only what this scene and these "
                    "settings call for.",
                    plan_table(run));
    html += section("Images",
                    "Of the frames kept during the run. Traced pixels are white. The pointer is a "
                    "lens onto the same place in all pictures of an eye.",
                    gallery(run, kMostGalleryBytes));
    html += section("Devices", "", device_table(run));
    html += section("Rays, memory, numerics", "", resource_table(run));
    html += section("Data",
                    "summary.json, frames.csv, plan.json and scenario.toml lie beside this "
                    "page; `foverig report` makes it again from them.",
                    repeating(run) + scenario_listing(run) + column_listing());
    return html + fmt::format("</main><script>\n{}</script></body></html>\n", kMagnifierScript);
}

}  // namespace foverig::report
