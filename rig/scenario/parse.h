#pragma once
// Scenario from TOML and from `key=value`. Every complaint is a UsageError that names the file,
// the line, what was found, what was expected and the nearest key.
#include <toml++/toml.h>
#include <filesystem>
#include <string>
#include <string_view>

#include "rig/scenario/scenario.h"

namespace foverig {

/// Defaults, then what the file says. A relative scene file is taken from the scenario's folder.
Scenario read_scenario(const std::filesystem::path& file);

/// `name` is what complaints call the text.
void apply_toml(Scenario& scenario, std::string_view text, const std::string& name);

/// The same of a table of another file: keys as a scenario has them at its top level. A relative
/// scene file is taken from that file's folder.
void apply_table(Scenario& scenario, const toml::table& table, const std::filesystem::path& file);

/// "foveation.p_min=0.1", as `--set` takes it. Text values need no quotes.
void apply_setting(Scenario& scenario, const std::string& setting);

/// The same for one key; `where` is what complaints begin with.
void apply_value(Scenario& scenario, const std::string& key, const std::string& text,
                 const std::string& where);

/// Fills in the number of frames where none was asked for, and checks keys that must fit each other
/// (r1_deg >= r0_deg, ...). Call once all sources were applied.
void complete_scenario(Scenario& scenario);

}  // namespace foverig
