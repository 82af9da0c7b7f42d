#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "rig/scenario/scenario.h"

namespace foverig {

/// Every key with its value and help: reads back to the same scenario.
std::string scenario_toml(const Scenario& scenario);

/// The same, nested by the dots of the names.
nlohmann::json scenario_json(const Scenario& scenario);

/// What `foverig run --help-scenario` prints: key, default, what is expected, help.
std::string scenario_help();

}  // namespace foverig
