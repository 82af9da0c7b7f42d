#include "rig/report/page.h"

#include <fmt/format.h>

#include "rig/records/columns.h"
#include "rig/report/facts.h"
#include "rig/report/frame_strip.h"
#include "rig/report/gallery.h"
#include "rig/report/latency_chain.h"
#include "rig/report/markup.h"
#include "rig/report/overview.h"
#include "rig/report/pass_bars.h"
#include "rig/report/style.h"

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

}  // namespace

std::string page(const RunData& run) {
    std::string html = fmt::format(
        "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width, initial-scale=1\"><title>foverig · {}</title>"
        "<style>{}</style></head><body><main>\n",
        escaped(title(run)), kStyle);
    html += overview(run);
    html += section("Frame times",
                    "Work of each frame, from its begin to its hand-over to the "
                    "display, without waiting.",
                    frame_strip(run));
    html += section("Where the time goes",
                    "Wall time of the renderer's passes: means above, then "
                    "frame by frame.",
                    pass_bars(run));
    html += section("Latency, link by link",
                    "From the instant a sensor took its sample to the "
                    "light of the frame that used it, mid-panel. Means add up; only frames that "
                    "were shown count.",
                    latency_chain(run));
    html += section("What was rendered, and why",
                    "The effect plan: only what this scene and these "
                    "settings call for.",
                    plan_table(run));
    html += section("Images", "Of the frames kept during the run. Traced pixels are white.",
                    gallery(run, kMostGalleryBytes));
    html += section("Devices", "", device_table(run));
    html += section("Rays, memory, numerics", "", resource_table(run));
    html += section("Data",
                    "summary.json, frames.csv, plan.json and scenario.toml lie beside this "
                    "page; `foverig report` makes it again from them.",
                    scenario_listing(run) + column_listing());
    return html + "</main></body></html>\n";
}

}  // namespace foverig::report
