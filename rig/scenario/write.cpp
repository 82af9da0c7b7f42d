#include "rig/scenario/write.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "rig/scenario/keys.h"
#include "rig/scenario/toml_value.h"

namespace foverig {
namespace {

/// "foveation.r0_deg" -> "foveation"; "" for a key of the top level.
std::string table_of(const std::string& name) {
    const auto dot = name.rfind('.');
    return dot == std::string::npos ? std::string() : name.substr(0, dot);
}

std::string leaf_of(const std::string& name) {
    return name.substr(name.rfind('.') + 1);  // npos + 1 == 0
}

}  // namespace

std::string scenario_toml(const Scenario& scenario) {
    std::string text = "# Resolved scenario: `foverig run` on this file repeats the run.\n";
    std::string table;
    for (const Key& key : scenario_keys()) {
        if (!key.present(scenario)) continue;
        if (table_of(key.name) != table) {
            table = table_of(key.name);
            text += fmt::format("\n[{}]\n", table);
        }
        text += fmt::format("# {}\n{} = {}\n", key.help, leaf_of(key.name),
                            toml_literal(key.get(scenario)));
    }
    return text;
}

nlohmann::json scenario_json(const Scenario& scenario) {
    nlohmann::json json = nlohmann::json::object();
    for (const Key& key : scenario_keys()) {
        if (!key.present(scenario)) continue;
        nlohmann::json* at = &json;
        std::string rest = key.name;
        for (auto dot = rest.find('.'); dot != std::string::npos; dot = rest.find('.')) {
            at = &(*at)[rest.substr(0, dot)];
            rest.erase(0, dot + 1);
        }
        std::visit([&](const auto& value) { (*at)[rest] = value; }, key.get(scenario));
    }
    return json;
}

std::string scenario_help() {
    const Scenario defaults;
    std::string text =
        "Scenario keys (TOML; on the command line: --set key=value). Each is shown with its "
        "default.\n";
    std::string table;
    for (const Key& key : scenario_keys()) {
        if (table_of(key.name) != table) {
            table = table_of(key.name);
            text += '\n';
        }
        const std::string value =
            key.present(defaults) ? toml_literal(key.get(defaults)) : "(absent)";
        text += fmt::format("{} = {}\n    {}\n    {}\n", key.name, value, key.help, key.expected);
    }
    return text;
}

}  // namespace foverig
