#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace foverig::sweep {

/// {"foveation.p_min": 0.05, ...} -> "p_min 0.05, ...": the names' last parts where they differ,
/// and short numbers.
std::string setting_text(const nlohmann::json& settings);

/// "0.05", "full", "[1,2]".
std::string value_text(const nlohmann::json& value);

}  // namespace foverig::sweep
