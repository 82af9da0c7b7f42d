#include "rig/sweep/setting_text.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace foverig::sweep {

std::string setting_text(const nlohmann::json& settings) {
    std::string text;
    for (const auto& [name, value] : settings.items())
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name.substr(name.rfind('.') + 1),
                            value_text(value));
    return text;
}

std::string value_text(const nlohmann::json& value) {
    if (value.is_number_float()) return fmt::format("{:.4g}", value.get<double>());
    if (value.is_string()) return value.get<std::string>();
    return value.dump();
}

}  // namespace foverig::sweep
