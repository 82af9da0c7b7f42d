#include "rig/records/elsewhere.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

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
    return fmt::format("{:.0f} % to other guests of its host, {:.0f} % to other programs",
                       100.0 * use.value("stolen_ratio", 0.0),
                       100.0 * use.value("others_ratio", 0.0));
}

}  // namespace foverig
