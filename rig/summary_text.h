#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace foverig {

/// The few lines of a summary that a person wants at the end of a run.
std::string summary_text(const nlohmann::json& summary);

/// The effect plan as a table of plain text.
std::string plan_text(const nlohmann::json& plan);

}  // namespace foverig
