#include "rig/sweep/page.h"

#include <fmt/format.h>

#include "rig/report/markup.h"
#include "rig/report/style.h"
#include "rig/sweep/plot.h"
#include "rig/sweep/price_table.h"
#include "rig/sweep/setting_text.h"

namespace foverig::sweep {
namespace {

using nlohmann::json;
using report::escaped;
using report::number;

constexpr const char* kPlotStyle = R"css(
.front { fill: none; stroke: var(--s0); stroke-width: 2; }
.on-front { fill: var(--s0); } .behind { fill: var(--s9); }
.interval { stroke: var(--soft); stroke-width: 1; opacity: 0.65; }
.default-ring { fill: none; stroke: var(--s1); stroke-width: 2.5; }
i.default-ring { border: 2.5px solid var(--s1); border-radius: 50%; background: none; }
i.on-front { background: var(--s0); border-radius: 50%; }
i.behind { background: var(--s9); border-radius: 50%; }
tr.chosen td { font-weight: 600; }
)css";

constexpr const char* kLegend =
    "<div class=\"legend\"><span><i class=\"on-front\"></i>on the front: no other setting is both "
    "faster and more accurate</span><span><i class=\"behind\"></i>behind it</span><span><i "
    "class=\"default-ring\"></i>the scenario as it is</span><span>lines: 95 % "
    "intervals</span></div>";

const json& point_at(const json& pareto, const json& number) {
    return pareto.at("points").at(number.get<std::size_t>());
}

std::string interval(const json& ci95) {
    if (ci95.is_null()) return "–";
    return fmt::format("{} to {}", number(ci95.at(0).get<double>()),
                       number(ci95.at(1).get<double>()));
}

std::string percentile(const json& p) {
    if (p.is_null()) return "–";
    return p.at("value").is_null() ? "n too small" : number(p.at("value").get<double>());
}

std::string settings_cell(const json& point) {
    const std::string text = escaped(setting_text(point.at("settings")));
    return point.at("default").get<bool>() ? text + " <b>(default)</b>" : text;
}

std::string memory_cell(const json& point) {
    const json& bytes = point.at("memory").at("backend_bytes");
    return report::bytes(bytes.is_null() ? std::nullopt : std::optional(bytes.get<double>()));
}

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
    return "mean absolute error of display codes, share of full scale";
}

std::string head(const json& pareto) {
    const json& sweep = pareto.at("sweep");
    const json& scenario = sweep.at("scenario");
    std::string hosts;
    for (const json& host : pareto.at("hosts"))
        hosts += fmt::format("{}{}, {} cores", hosts.empty() ? "" : "; ",
                             escaped(value_text(host.at("cpu"))), host.at("cores").dump());
    return fmt::format(
        "<h1>What accuracy costs in time: {}</h1><p class=\"identity\">{} · {} x {} pixels, {} "
        "eye(s) · {} frames a run, {} of them warm-up · {} · {} points · foverig {} ({}), {}</p>",
        escaped(sweep.at("name").get<std::string>()),
        escaped(scenario.at("scene").get<std::string>()),
        scenario.at("display").at("eye_width_px").dump(),
        scenario.at("display").at("eye_height_px").dump(), scenario.at("display").at("eyes").dump(),
        scenario.at("frames").dump(), sweep.at("warm_up_frames").dump(),
        pareto.at("modelled").get<bool>()
            ? "times are modelled: fixed cost"
            : sweep.at("repetitions").dump() + " runs a point, interleaved",
        pareto.at("points").size(), escaped(value_text(pareto.at("build").at("version"))),
        escaped(value_text(pareto.at("build").at("git"))), hosts);
}

std::string front_table(const json& pareto) {
    std::vector<std::vector<std::string>> rows;
    for (const json& place : pareto.at("front")) {
        const json& next = place.at("to_next");
        rows.push_back(
            {place.at("point").dump(), settings_cell(point_at(pareto, place.at("point"))),
             number(place.at("time_ms").get<double>()), number(place.at("error").get<double>()),
             next.is_null() ? "–" : number(next.at("ms").get<double>()),
             next.is_null() ? "–" : number(next.at("error_per_ms").get<double>())});
    }
    return report::table({"point", "settings", "ms", "error", "ms to the next", "error per ms"},
                         rows, {0, 2, 3, 4, 5});
}

std::string within_table(const json& pareto) {
    std::vector<std::vector<std::string>> rows;
    for (const json& wish : pareto.at("cheapest_within")) {
        const bool found = !wish.at("point").is_null();
        rows.push_back(
            {number(wish.at("error").get<double>()),
             found ? settings_cell(point_at(pareto, wish.at("point"))) : "no setting of this sweep",
             found ? number(wish.at("time_ms").get<double>()) : "–"});
    }
    return rows.empty() ? ""
                        : report::table({"error at most", "cheapest settings", "ms"}, rows, {0, 2});
}

std::string time_table(const json& pareto) {
    std::vector<std::vector<std::string>> rows;
    for (const json& point : pareto.at("points")) {
        const json& time = point.at("time_ms");
        rows.push_back(
            {point.at("point").dump(), settings_cell(point), number(time.at("value").get<double>()),
             interval(time.at("ci95")), percentile(time.at("p99")),
             report::percent(point.at("vsync").at("missed_ratio").get<double>()),
             report::count(point.at("rays").at("total").get<double>()), memory_cell(point)});
    }
    return report::table(
        {"point", "settings", "ms", "95 %", "p99 ms", "VSyncs missed", "rays a frame", "memory"},
        rows, {0, 2, 3, 4, 5, 6, 7});
}

std::string error_table(const json& pareto) {
    const auto axis = pareto.at("error").get<std::string>();
    std::vector<std::vector<std::string>> rows;
    for (const json& point : pareto.at("points")) {
        const json& errors = point.at("error");
        const json& error = errors.at(axis);
        std::vector<std::string> row{
            point.at("point").dump(), settings_cell(point), number(error.at("mean").get<double>()),
            interval(error.at("ci95")), number(error.at("max").get<double>())};
        for (const char* name : {"flip", "absolute", "fovea", "periphery"})
            row.push_back(number(errors.at(name).at("mean").get<double>()));
        rows.push_back(std::move(row));
    }
    return report::table({"point", "settings", axis, "95 %", "worst frame", "FLIP", "absolute",
                          "fovea", "periphery"},
                         rows, {0, 2, 3, 4, 5, 6, 7, 8});
}

/// Passes of the front's points side by side: where the milliseconds go.
std::string pass_table(const json& pareto) {
    std::vector<std::string> heads{"pass, ms a frame"};
    std::map<std::string, std::vector<std::string>> rows_of;
    std::vector<std::size_t> numeric;
    for (const json& place : pareto.at("front")) {
        heads.push_back("point " + place.at("point").dump());
        numeric.push_back(heads.size() - 1);
        const json& passes = point_at(pareto, place.at("point")).at("pass_time_ms");
        for (const auto& [pass, ms] : passes.items()) {
            auto& row = rows_of[pass];
            row.resize(heads.size() - 2, "–");
            row.push_back(number(ms.get<double>()));
        }
    }
    std::vector<std::vector<std::string>> rows;
    for (auto& [pass, cells] : rows_of) {
        cells.resize(heads.size() - 1, "–");
        cells.insert(cells.begin(), "<code>" + escaped(pass) + "</code>");
        rows.push_back(cells);
    }
    return rows.empty() ? "" : report::table(heads, rows, numeric);
}

std::string listing(const char* title, const json& value) {
    return fmt::format("<details><summary>{}</summary><pre>{}</pre></details>", title,
                       escaped(value.dump(2)));
}

}  // namespace

std::string page(const json& pareto) {
    const auto axis = pareto.at("error").get<std::string>();
    std::string html = fmt::format(
        "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width, initial-scale=1\"><title>foverig sweep · {}</title>"
        "<style>{}{}</style></head><body><main>\n",
        escaped(pareto.at("sweep").at("name").get<std::string>()), report::kStyle, kPlotStyle);
    html += head(pareto);
    html += report::section(
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
    if (pareto.contains("prices"))
        html += report::section(
            "What each effect costs and what it buys",
            "The scenario as it is, against itself with one effect left out. Spent: milliseconds "
            "that the effect adds. Error removed: what the error would be more without it; below "
            "0 it adds error, as foveation does to save time: then error per ms is what a saved "
            "millisecond costs. Intervals are of the differences, "
            "run by run and frame by frame.",
            price_table(pareto));
    if (const std::string table = pass_table(pareto); !table.empty())
        html += report::section("Where the time goes along the front",
                                "Means of all runs beyond the warm-up.", table);
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
