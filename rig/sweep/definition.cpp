#include "rig/sweep/definition.h"

#include <fmt/format.h>

#include "rig/failure.h"
#include "rig/scenario/parse.h"
#include "rig/scenario/toml_value.h"

namespace foverig::sweep {

Scenario with_settings(const Scenario& base, const Settings& settings) {
    Scenario scenario = base;
    try {
        for (const auto& [name, value] : settings) {
            const Key& key = *find_key(name);
            if (const auto complaint = key.set(scenario, value))
                throw UsageError(
                    fmt::format("{} is {}; expected {}", name, toml_literal(value), *complaint));
        }
        complete_scenario(scenario);
    } catch (const UsageError& error) {
        throw UsageError(fmt::format("point {}: {}", text_of(settings), error.what()));
    }
    return scenario;
}

std::string text_of(const Settings& settings) {
    std::string text;
    for (const auto& [name, value] : settings)
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, toml_literal(value));
    return text;
}

}  // namespace foverig::sweep
