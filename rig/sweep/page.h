#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace foverig::sweep {

/// pareto.html from a pareto.json: one file, no request to anywhere, no script, light and dark.
std::string page(const nlohmann::json& pareto);

}  // namespace foverig::sweep
