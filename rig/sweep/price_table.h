#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace foverig::sweep {

/// The `prices` of a pareto.json as a table of the page.
std::string price_table(const nlohmann::json& pareto);

}  // namespace foverig::sweep
