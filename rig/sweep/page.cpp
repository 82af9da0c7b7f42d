#include "rig/sweep/page.h"

#include <fmt/format.h>

#include "rig/records/elsewhere.h"
#include "rig/report/markup.h"
#include "rig/report/provenance.h"
#include "rig/report/style.h"
#include "rig/sweep/knob_charts.h"
#include "rig/sweep/page_tables.h"
#include "rig/sweep/paper_chart.h"
#include "rig/sweep/paper_section.h"
#include "rig/sweep/plot.h"
#include "rig/sweep/price_table.h"
#include "rig/sweep/setting_text.h"

namespace foverig::sweep {
namespace {

using nlohmann::json;
using report::escaped;

constexpr const char* kPlotStyle = R"css(
.front { fill: none; stroke: var(--s0); stroke-width: 2; }
.on-front { fill: var(--s0); } .behind { fill: var(--s9); }
.interval { stroke: var(--soft); stroke-width: 1; opacity: 0.65; }
.default-ring { fill: none; stroke: var(--s1); stroke-width: 2.5; }
i.default-ring { border: 2.5px solid var(--s1); border-radius: 50%; background: none; }
i.on-front { background: var(--s0); border-radius: 50%; }
i.behind { background: var(--s9); border-radius: 50%; }
polyline.line { fill: none; stroke-width: 2; } polyline.s0 { stroke: var(--s0); }
polyline.s1 { stroke: var(--s1); } polyline.s2 { stroke: var(--s2); }
polyline.s3 { stroke: var(--s3); } polyline.s4 { stroke: var(--s4); }
polyline.s5 { stroke: var(--s5); } polyline.s6 { stroke: var(--s6); }
polyline.s7 { stroke: var(--s7); } polyline.s8 { stroke: var(--s8); }
polyline.s9 { stroke: var(--s9); }
svg .mark-name { font-weight: 600; font-size: 13px; paint-order: stroke; stroke: var(--paper);
  stroke-width: 4px; }
)css";

constexpr const char* kLegend =
    "<div class=\"legend\"><span><i class=\"on-front\"></i>on the front: no other setting is both "
    "faster and more accurate</span><span><i class=\"behind\"></i>behind it</span><span><i "
    "class=\"default-ring\"></i>the scenario as it is</span><span>lines: 95 % "
    "intervals</span></div>";

std::string definition_of(const std::string& error) {
    if (error == "flip") return "mean of LDR-FLIP (Andersson et al. 2020), 0 to 1";
    if (error == "acuity")
        return "acuity-weighted error, our own definition: the absolute error of display codes, as "
               "share "
               "of full scale, averaged so that each cell which the eye can resolve at its "
               "distance from "
               "the gaze counts once";
    if (error == "flip_acuity")
        return "LDR-FLIP averaged in the same way as the acuity-weighted error";
    if (error == "fovea")
        return "mean absolute error within 10 degrees of the gaze, share of full scale";
    if (error == "periphery")
        return "mean absolute error beyond 10 degrees of the gaze, share of full scale";
    if (error == "change")
        return "change from frame to frame that the reference has not: mean |(T' - T) - (R' - R)| "
               "of display codes, share of full scale";
    if (error == "flicker")
        return "flicker, our own definition: root mean square of the luma error's transient "
               "channel, share of full scale";
    if (error == "fvvdp")
        return "10 less the JOD of FovVideoVDP (Mantiuk et al. 2021) at the gaze, frame by frame "
               "as those before let it be seen; 1 is seen by 75 % of people";
    return "mean absolute error of display codes, share of full scale";
}

std::string shown_scenes(const json& sweep) {
    if (!sweep.contains("cases"))
        return escaped(sweep.at("scenario").at("scene").get<std::string>());
    return fmt::format("{} cases", sweep.at("cases").size());
}

std::string shown_frames(const json& sweep) {
    const std::string flight = sweep.at("scenario").at("frames").dump();
    const std::string warm_up = sweep.at("warm_up_frames").dump();
    if (!sweep.contains("stretches"))
        return fmt::format("{} frames a run, {} of them warm-up", flight, warm_up);
    return fmt::format("{} stretches of {} frames, {} of each warm-up, of a flight of {}",
                       sweep.at("stretches").at("count").dump(),
                       sweep.at("stretches").at("frames").dump(), warm_up, flight);
}

/// As a run's report has it; the folder of an older sweep does not say what its devices were.
std::string what_was_simulated(const json& pareto) {
    const json& sweep = pareto.at("sweep");
    report::RunData run;
    run.summary = {{"scenario", sweep.at("scenario")},
                   {"devices", sweep.value("devices", json::object())},
                   {"fixed_cost", pareto.at("modelled")}};
    return report::provenance(run);
}

/// What the times' intervals cannot be blamed on the settings for.
std::string not_alone(const json& pareto) {
    const json elsewhere = pareto.value("elsewhere_processors", json());
    if (!elsewhere.is_object() || elsewhere.at("max").get<double>() < kElsewhereMatters_processors)
        return "";
    return fmt::format(
        "While a run was timed, others had up to {:.1f} of the machine's processors (p50 of the "
        "runs "
        "{:.1f}): trust intervals and ratios more than milliseconds.",
        elsewhere.at("max").get<double>(), elsewhere.at("p50").get<double>());
}

std::string head(const json& pareto) {
    const json& sweep = pareto.at("sweep");
    const json& display = sweep.at("scenario").at("display");
    std::string hosts;
    for (const json& host : pareto.at("hosts"))
        hosts += fmt::format("{}{}, {} cores", hosts.empty() ? "" : "; ",
                             escaped(value_text(host.at("cpu"))), host.at("cores").dump());
    return fmt::format(
        "<h1>What accuracy costs in time: {}</h1><p class=\"identity\">{} · {} x {} pixels, {} "
        "· {} · {} · {} points · foverig {} ({}), {}</p><p class=\"identity\">{}</p>",
        escaped(sweep.at("name").get<std::string>()), shown_scenes(sweep),
        display.at("eye_width_px").dump(), display.at("eye_height_px").dump(),
        display.at("eyes") == 1 ? "one eye" : "both eyes", shown_frames(sweep),
        pareto.at("modelled").get<bool>()
            ? "times are modelled: fixed cost"
            : sweep.at("repetitions").dump() + " runs a point, interleaved",
        pareto.at("points").size(), escaped(value_text(pareto.at("build").at("version"))),
        escaped(value_text(pareto.at("build").at("git"))), hosts,
        escaped(what_was_simulated(pareto) + not_alone(pareto)));
}

std::string listing(const char* title, const json& value) {
    return fmt::format("<details><summary>{}</summary><pre>{}</pre></details>", title,
                       escaped(value.dump(2)));
}

/// How the error follows from the knobs that the sweep names.
std::string knob_section(const json& pareto, const std::string& axis) {
    const std::string charts = knob_charts(pareto);
    if (charts.empty()) return "";
    return report::section(
        "Error over the knobs",
        fmt::format("Error: {}, mean of the frames beyond the warm-up. {}", definition_of(axis),
                    pareto.at("sweep").value("errors_at", "tracker") == "truth"
                        ? "Gaze is where the eyes really looked when the light came (in a replay: "
                          "where the recorded tracker said), not where this tracker said."
                        : "Gaze is where the tracker said that the eyes look."),
        charts);
}

/// Plot, steps and wishes of a sweep that shows one thing. Where all cost the same there is no
/// front to show.
std::string front_sections(const json& pareto, const std::string& axis) {
    if (pareto.at("modelled").get<bool>() && pareto.at("sweep").contains("over")) return "";
    std::string html = report::section(
        "Error against time",
        fmt::format(
            "Error: {}, mean of the frames beyond the warm-up; its interval is over blocks of "
            "frames. Time: renderer and lens distortion, mean of the runs' medians; its "
            "interval is over runs (Student). Every point was shown the same frames.",
            definition_of(axis)),
        plot(pareto) + kLegend);
    html += report::section("What one more millisecond buys",
                            "The front from its cheapest point on; error per ms is the change of "
                            "the error on the way to "
                            "the next point, over the milliseconds that it costs.",
                            front_table(pareto));
    if (const std::string table = within_table(pareto); !table.empty())
        html += report::section("The cheapest setting within an error", "", table);
    return html;
}

/// The paper's numbers, and a plot of each case that has a choice to offer.
std::string case_sections(const json& pareto, const std::string& axis) {
    constexpr std::size_t kFewestToPlot = 3;
    std::string html = pareto.contains("paper") ? paper_section(pareto) : "";
    for (const json& one : pareto.at("cases")) {
        if (one.at("points").size() < kFewestToPlot) continue;
        json alone = {{"error", pareto.at("error")},
                      {"budget_ms", pareto.at("budget_ms")},
                      {"points", json::array()},
                      {"front", one.at("front")}};
        for (const json& point : one.at("points"))
            alone["points"].push_back(pareto.at("points").at(point.get<std::size_t>()));
        html += report::section(
            "Error against time: " + escaped(one.at("name").get<std::string>()),
            fmt::format("Error: {}, against the same scene traced in full.", definition_of(axis)),
            plot(alone) + kLegend);
    }
    return html;
}

}  // namespace

std::string page(const json& pareto) {
    const auto axis = pareto.at("error").get<std::string>();
    std::string html =
        report::page_head("foverig sweep · " + pareto.at("sweep").at("name").get<std::string>(),
                          std::string(report::kStyle) + kPlotStyle + kPaperStyle);
    html += head(pareto);
    html += knob_section(pareto, axis);
    html += pareto.contains("cases") ? case_sections(pareto, axis) : front_sections(pareto, axis);
    if (pareto.contains("prices"))
        html += report::section(
            "What each effect costs and what it buys",
            "The scenario as it is, against itself with one effect left out. Spent: milliseconds "
            "that the effect adds. Error removed: what the error would be more without it; below "
            "0 it adds error, as foveation does to save time: then error per ms is what a saved "
            "millisecond costs. Intervals are of the differences, "
            "run by run and frame by frame; none stands where runs or frames are too few for one.",
            price_table(pareto));
    if (const std::string table = pass_table(pareto); !table.empty())
        html += report::section("Where the time goes along the front",
                                "Means of all runs beyond the warm-up, the longest first.", table);
    html += report::section("Times of all points",
                            "VSyncs missed: had every frame begun at a VSync. p99 needs 299 "
                            "independent frames, else n is too small.",
                            time_table(pareto));
    html +=
        report::section("Errors of all points",
                        "Means over the frames; docs/sweeps.md defines each.", error_table(pareto));
    html +=
        report::section("Data",
                        "pareto.json lies beside this page and holds all of it; `foverig report` "
                        "makes both again from the runs*.jsonl.",
                        listing("Scenario", pareto.at("sweep").at("scenario")) +
                            listing("Reference", pareto.at("sweep").at("reference")) +
                            listing("Build", pareto.at("build")));
    return html + "</main></body></html>\n";
}

}  // namespace foverig::sweep
