#include "rig/sweep/price_table.h"

#include <fmt/format.h>

#include "rig/report/markup.h"

namespace foverig::sweep {
namespace {

using nlohmann::json;
using report::number;

std::string value_cell(const json& estimated) {
    return estimated.is_object() ? number(estimated.at("value").get<double>()) : "–";
}

std::string interval_cell(const json& estimated) {
    if (!estimated.is_object() || estimated.at("ci95").is_null()) return "–";
    return fmt::format("{} to {}", number(estimated.at("ci95").at(0).get<double>()),
                       number(estimated.at("ci95").at(1).get<double>()));
}

}  // namespace

std::string price_table(const json& pareto) {
    std::vector<std::vector<std::string>> rows;
    for (const json& price : pareto.at("prices")) {
        const json& per_ms = price.at("error_per_ms");
        rows.push_back(
            {"<code>" + report::escaped(price.at("effect").get<std::string>()) + "</code>",
             "<code>" + report::escaped(price.at("left_out").get<std::string>()) + "</code>",
             value_cell(price.at("ms")), interval_cell(price.at("ms")),
             value_cell(price.at("error")), interval_cell(price.at("error")),
             per_ms.is_null() ? "–" : number(per_ms.get<double>())});
    }
    if (rows.empty()) return "<p>The plan has no effect that can be left out.</p>";
    return report::table({"effect", "left out by", "ms spent", "95 %", "error removed", "95 %",
                          "error removed per ms"},
                         rows, {2, 3, 4, 5, 6});
}

}  // namespace foverig::sweep
