#include "rig/compare/told.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rig/records/elsewhere.h"
#include "rig/stats/centre.h"

namespace foverig::compare {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostPasses = 6;
constexpr const char* kProcessorTime = "cpu_ms";

std::string runs_text(const char* side, const std::vector<double>& medians) {
    const auto [least, most] = std::minmax_element(medians.begin(), medians.end());
    return fmt::format("{:<8} {} run{}, median {:.5g} ({:.5g} to {:.5g})\n", side, medians.size(),
                       medians.size() == 1 ? "" : "s", stats::median_of(medians), *least, *most);
}

std::string with_interval(const stats::Shift& shift, double scale, const char* unit) {
    if (!shift.ci95) return fmt::format("{:+.3g}{}", shift.value * scale, unit);
    return fmt::format("{:+.3g}{} [{:+.3g}, {:+.3g}]", shift.value * scale, unit,
                       shift.ci95->low * scale, shift.ci95->high * scale);
}

/// Columns carry theirs in their names.
const char* unit_of(const std::string& column) {
    if (column.ends_with("_ms")) return " ms";
    if (column.ends_with("_deg")) return " deg";
    return column.ends_with("_ns") ? " ns" : "";
}

std::string reason(const TimeComparison& c, double threshold) {
    const double percent = 100.0 * threshold;
    switch (c.judgement.verdict) {
        case stats::Verdict::worse:
            return fmt::format("all of the interval is beyond +{:.3g} %", percent);
        case stats::Verdict::better:
            return fmt::format("all of the interval is beyond -{:.3g} %", percent);
        case stats::Verdict::same:
            return fmt::format("all of the interval is within {:.3g} %", percent);
        case stats::Verdict::cannot_tell:
            break;
    }
    const auto runs = c.judgement.runs_needed;
    if (!c.relative.ci95)
        return fmt::format("too few runs; at least {} a side have an interval", *runs);
    const std::string what =
        fmt::format("the interval holds {}{:.3g} %; ", c.relative.value < 0.0 ? "-" : "+", percent);
    return what + (runs
                       ? fmt::format("about {} runs a side would tell", *runs)
                       : fmt::format("more than {} runs a side would be needed", stats::kMostRuns));
}

Json shift_json(const stats::Shift& shift) {
    Json json = {{"value", shift.value}, {"ci95", nullptr}};
    if (shift.ci95) json["ci95"] = {shift.ci95->low, shift.ci95->high};
    return json;
}

bool has_column(const std::vector<report::RunData>& runs, const std::string& column) {
    return std::all_of(runs.begin(), runs.end(), [&](const report::RunData& run) {
        const auto cells = run.frames.column(column);
        return std::any_of(cells.begin(), cells.end(), [](const auto& c) { return c.has_value(); });
    });
}

}  // namespace

std::vector<PassShift> pass_shifts(const std::vector<report::RunData>& base,
                                   const std::vector<report::RunData>& fresh,
                                   const TimeComparison& comparison, bool paired) {
    std::vector<PassShift> shifts;
    for (const std::string& column : base.front().frames.order) {
        if (!column.starts_with("pass.") || !has_column(base, column) || !has_column(fresh, column))
            continue;
        const auto before = medians_of(base, column, comparison.warm_up_frames);
        const auto after = medians_of(fresh, column, comparison.warm_up_frames);
        shifts.push_back(
            {column.substr(5, column.size() - 5 - 3),
             paired ? stats::paired_shift(before, after) : stats::shift_between(before, after)});
    }
    std::stable_sort(shifts.begin(), shifts.end(), [](const PassShift& a, const PassShift& b) {
        return std::abs(a.shift_ms.value) > std::abs(b.shift_ms.value);
    });
    return shifts;
}

std::string told(const TimeComparison& c, const TimeSettings& settings,
                 const std::vector<PassShift>& passes) {
    std::string text = runs_text("base", c.base) + runs_text("new", c.fresh);
    text += fmt::format("of       {}, median of each run{}\n", settings.of,
                        settings.paired ? ", runs in pairs" : "");
    if (c.warm_up_frames > 0)
        text += fmt::format("warm-up  the first {} frames of every run are left out\n",
                            c.warm_up_frames);
    // What others had is not in processor time, and of a duet it is the partner's.
    if (settings.of != kProcessorTime &&
        c.elsewhere_processors.value_or(0.0) >= kElsewhereMatters_processors)
        text += fmt::format(
            "machine  others had up to {:.1f} of its processors during a run; --of cpu_ms leaves "
            "that "
            "out\n",
            *c.elsewhere_processors);
    text += fmt::format("shift    {}, {}{}\n", with_interval(c.shift, 1.0, unit_of(settings.of)),
                        with_interval(c.relative, 100.0, " %"), c.shift.ci95 ? ", 95 %" : "");
    for (std::size_t i = 0; i < std::min(passes.size(), kMostPasses); ++i)
        text += fmt::format("  pass   {:<24} {}\n", passes[i].pass,
                            with_interval(passes[i].shift_ms, 1.0, " ms"));
    return text + fmt::format("{}: {}\n", stats::name_of(c.judgement.verdict),
                              reason(c, settings.threshold));
}

Json to_json(const TimeComparison& c, const TimeSettings& settings,
             const std::vector<PassShift>& passes) {
    Json json = {{"verdict", stats::name_of(c.judgement.verdict)},
                 {"of", settings.of},
                 {"threshold", settings.threshold},
                 {"paired", settings.paired},
                 {"warm_up_frames", c.warm_up_frames},
                 {"elsewhere_processors", nullptr},
                 {"base", c.base},
                 {"new", c.fresh},
                 {"shift", shift_json(c.shift)},
                 {"relative_shift", shift_json(c.relative)},
                 {"runs_needed", nullptr},
                 {"passes", Json::object()}};
    if (c.elsewhere_processors) json["elsewhere_processors"] = *c.elsewhere_processors;
    if (c.judgement.runs_needed) json["runs_needed"] = *c.judgement.runs_needed;
    for (const PassShift& pass : passes) json["passes"][pass.pass] = shift_json(pass.shift_ms);
    return json;
}

}  // namespace foverig::compare
