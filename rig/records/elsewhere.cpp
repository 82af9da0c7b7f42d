#include "rig/records/elsewhere.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

namespace foverig {

std::optional<double> elsewhere_processors(const nlohmann::json& summary) {
    const auto use = summary.find("processor_use");
    if (use == summary.end() || !use->is_object()) return std::nullopt;
    return use->value("others", 0.0) + use->value("stolen", 0.0);
}

std::string elsewhere_text(const nlohmann::json& summary) {
    const auto processors = elsewhere_processors(summary);
    if (!processors || *processors < kElsewhereMatters_processors) return "";
    const auto& use = summary["processor_use"];
    std::string text;
    for (const auto& [key, to] :
         {std::pair("stolen", "other guests of its host"), std::pair("others", "other programs")})
        if (const double had = use.value(key, 0.0); had >= 0.05)  // else it reads 0.0
            text += fmt::format("{}{:.1f} to {}", text.empty() ? "" : ", ", had, to);
    return fmt::format("{:.1f} of {} processors: {}", *processors, use.value("processors", 1),
                       text);
}

}  // namespace foverig
