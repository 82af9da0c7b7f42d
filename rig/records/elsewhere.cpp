#include "rig/records/elsewhere.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

namespace foverig {

std::optional<double> elsewhere_ratio(const nlohmann::json& summary) {
    const auto use = summary.find("processor_use");
    if (use == summary.end() || !use->is_object()) return std::nullopt;
    return use->value("others_ratio", 0.0) + use->value("stolen_ratio", 0.0);
}

std::string elsewhere_text(const nlohmann::json& summary) {
    const auto ratio = elsewhere_ratio(summary);
    if (!ratio || *ratio < kElsewhereMatters_ratio) return "";
    const auto& use = summary["processor_use"];
    std::string text;
    for (const auto& [key, to] : {std::pair("stolen_ratio", "other guests of its host"),
                                  std::pair("others_ratio", "other programs")})
        if (const double percent = 100.0 * use.value(key, 0.0); percent >= 0.5)
            text += fmt::format("{}{:.0f} % to {}", text.empty() ? "" : ", ", percent, to);
    return text;
}

}  // namespace foverig
