#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace foverig::sweep {

/// "Beside the paper": chart, ratios and absolute numbers, the paper's beside ours. Of a
/// pareto.json that has `paper`.
std::string paper_section(const nlohmann::json& pareto);

}  // namespace foverig::sweep
