#include "rig/sweep/page_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "rig/report/markup.h"
#include "rig/sweep/setting_text.h"

namespace foverig::sweep {
namespace {

using nlohmann::json;
using report::escaped;
using report::number;

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
    if (point.contains("case"))
        return escaped(fmt::format("{}: {}", point.at("case").get<std::string>(),
                                   point.at("variant").get<std::string>()));
    const std::string text = escaped(setting_text(point.at("settings")));
    return point.at("default").get<bool>() ? text + " <b>(default)</b>" : text;
}

std::string memory_cell(const json& point) {
    const json& bytes = point.at("memory").at("backend_bytes");
    return report::bytes(bytes.is_null() ? std::nullopt : std::optional(bytes.get<double>()));
}

/// Milliseconds of a pass at each place of the front; absent where it did not run.
using AlongFront = std::vector<std::optional<double>>;

double sum_of(const AlongFront& times_ms) {
    double sum = 0.0;
    for (const auto& ms : times_ms) sum += ms.value_or(0.0);
    return sum;
}

}  // namespace

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
                        : report::table({"error at most", "cheapest settings", "ms"}, rows, {2});
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
        std::vector<std::string> row{point.at("point").dump(),
                                     settings_cell(point),
                                     number(error.at("mean").get<double>()),
                                     interval(error.at("ci95")),
                                     percentile(error.at("p90")),
                                     number(error.at("max").get<double>())};
        for (const char* name : {"flip", "absolute", "fovea", "periphery", "flicker"})
            row.push_back(errors.contains(name) ? number(errors.at(name).at("mean").get<double>())
                                                : "–");  // measured before there was such an error
        rows.push_back(std::move(row));
    }
    return report::table({"point", "settings", axis, "95 %", "p90", "worst frame", "FLIP",
                          "absolute", "fovea", "periphery", "flicker"},
                         rows, {0, 2, 3, 4, 5, 6, 7, 8, 9, 10});
}

std::string pass_table(const json& pareto) {
    const json& front = pareto.at("front");
    std::vector<std::string> heads{"pass, ms a frame"};
    std::vector<std::size_t> numeric;
    std::map<std::string, AlongFront> by_name;
    for (std::size_t i = 0; i < front.size(); ++i) {
        heads.push_back("point " + front[i].at("point").dump());
        numeric.push_back(i + 1);
        const json& passes = point_at(pareto, front[i].at("point")).at("pass_time_ms");
        for (const auto& [pass, ms] : passes.items())
            by_name.try_emplace(pass, front.size()).first->second[i] = ms.get<double>();
    }
    std::vector<std::pair<std::string, AlongFront>> passes(by_name.begin(), by_name.end());
    std::stable_sort(passes.begin(), passes.end(), [](const auto& a, const auto& b) {
        return sum_of(a.second) > sum_of(b.second);
    });
    std::vector<std::vector<std::string>> rows;
    for (const auto& [pass, times_ms] : passes) {
        rows.push_back({"<code>" + escaped(pass) + "</code>"});
        for (const auto& ms : times_ms) rows.back().push_back(number(ms));
    }
    return rows.empty() ? "" : report::table(heads, rows, numeric);
}

}  // namespace foverig::sweep
