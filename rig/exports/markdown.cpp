#include "rig/exports/markdown.h"

#include <fmt/format.h>

#include "rig/records/elsewhere.h"
#include "rig/report/provenance.h"

namespace foverig::exports {
namespace {

using nlohmann::json;

std::string number(const json& value, const char* unit = "") {
    return value.is_number() ? fmt::format("{:.4g}{}", value.get<double>(), unit) : "–";
}

/// Cells are free text: a bar would end them.
std::string cell(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '|') safe += '\\';
        safe += c;
    }
    return safe;
}

void row(std::string& table, const std::string& name, const std::string& value,
         const std::string& detail) {
    table += fmt::format("| {} | {} | {} |\n", cell(name), cell(value), cell(detail));
}

std::string interval(const json& percentile) {
    if (!percentile.at("value").is_number())
        return fmt::format("n too small: {} independent frames of {}",
                           number(percentile.at("effective_n")), number(percentile.at("needed_n")));
    return fmt::format("95 % {} to {}", number(percentile.at("ci95").at(0)),
                       number(percentile.at("ci95").at(1), " ms"));
}

void add_times(std::string& table, const json& summary) {
    const json steady = summary.value("steady_frame_time_ms", json());
    if (!steady.is_object()) {
        row(table, "frame time", number(summary.at("frame_time_ms").at("p50"), " ms"),
            "modelled: fixed cost");
        return;
    }
    const std::string warm_up =
        fmt::format("; without {} frames of warm-up", number(steady.at("warm_up_frames")));
    row(table, "frame time p50", number(steady.at("p50").at("value"), " ms"),
        interval(steady.at("p50")) + warm_up);
    row(table, "frame time p99", number(steady.at("p99").at("value"), " ms"),
        interval(steady.at("p99")) + warm_up);
    const std::string elsewhere = elsewhere_text(summary);
    if (const json cpu = summary.value("cpu_time_ms", json()); cpu.is_object())
        row(table, "processor time p50", number(cpu.at("p50"), " ms"),
            elsewhere.empty() ? "" : "elsewhere went " + elsewhere);
}

std::string effects(const json& plan) {
    std::string table = "\n| effect | ms a frame | because |\n|---|---|---|\n";
    for (const json& effect : plan) {
        if (!effect.at("on").get<bool>()) continue;
        row(table, effect.at("effect").get<std::string>(), number(effect.at("measured_ms")),
            effect.at("because").get<std::string>());
    }
    return table;
}

}  // namespace

std::string markdown(const report::RunData& run) {
    const json& s = run.summary;
    std::string text = fmt::format(
        "### foverig: {}, {} on {}\n\nVersion {} ({}), {}, {}{}\n\n{}\n\n| | | |\n|---|---|---|\n",
        run.text({"scenario", "scene"}), run.text({"pipeline"}), run.text({"build", "backend"}),
        run.text({"build", "version"}), run.text({"build", "git"}), run.text({"build", "type"}),
        run.text({"host", "cpu"}), s.at("interrupted").get<bool>() ? " · **ended early**" : "",
        report::provenance(run));
    add_times(text, s);
    const json& vsync = s.at("vsync");
    const auto missed = run.number({"vsync", "missed_ratio"});
    row(text, "VSyncs missed", missed ? fmt::format("{:.2f} %", 100.0 * *missed) : "–",
        fmt::format("{} of {} at {}", number(vsync.at("missed")), number(vsync.at("total")),
                    number(vsync.at("rate_hz"), " Hz")));
    row(text, "frames dropped", number(s.at("frames").at("dropped")),
        fmt::format("of {} rendered", number(s.at("frames").at("rendered"))));
    row(text, "frames mis-presented", number(s.at("frames").value("mis_presented", json())),
        "shown at another VSync than their pictures are of");
    for (const auto& [name, key] : {std::pair("motion to photon", "motion_to_photon"),
                                    std::pair("gaze to photon", "gaze_to_photon")}) {
        const json& latency = s.at("latency_ms").at(key);
        if (latency.is_object())
            row(text, name, number(latency.at("p50"), " ms"),
                "p99 " + number(latency.at("p99"), " ms"));
    }
    if (const auto ratio = run.number({"sampled_pixel_ratio"}))
        row(text, "traced pixels", fmt::format("{:.1f} %", 100.0 * *ratio), "of all");
    if (const json governor = s.value("governor", json()); governor.is_object())
        row(text, "governor", fmt::format("{} changes", number(governor.at("changes"))),
            governor.at("error_paid").is_number()
                ? fmt::format("mean {} {} where measured", governor.value("error_name", ""),
                              number(governor.at("error_paid")))
                : "errors not known");
    if (const auto nan = run.number({"numerics", "nan"}); nan && *nan > 0.0)
        row(text, "**NaN met**", number(s.at("numerics").at("nan")), "this run is not valid");
    return text + effects(s.at("plan"));
}

}  // namespace foverig::exports
