#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace foverig::sweep {

/// {"foveation.p_min": 0.05, ...} -> "p_min 0.05, ...": last parts of the names, numbers short.
std::string setting_text(const nlohmann::json& settings);

/// "0.05", "full", "[1,2]".
std::string value_text(const nlohmann::json& value);

}  // namespace foverig::sweep
