#include "rig/sweep/setting_text.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

namespace foverig::sweep {

namespace {

std::string last_part(const std::string& name) {
    return name.substr(name.rfind('.') + 1);
}

}  // namespace

std::string setting_text(const nlohmann::json& settings) {
    std::map<std::string, int> alike;
    for (const auto& [name, value] : settings.items()) ++alike[last_part(name)];
    std::string text;
    for (const auto& [name, value] : settings.items()) {
        const std::string part = last_part(name);
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", alike[part] > 1 ? name : part,
                            value_text(value));
    }
    return text;
}

std::string value_text(const nlohmann::json& value) {
    if (value.is_number_float()) return fmt::format("{:.4g}", value.get<double>());
    if (value.is_string()) return value.get<std::string>();
    return value.dump();
}

}  // namespace foverig::sweep
