#pragma once
// Tables of a sweep's page, each of a pareto.json.
#include <nlohmann/json.hpp>
#include <string>

namespace foverig::sweep {

/// The front from its cheapest point on, and what the next millisecond buys.
std::string front_table(const nlohmann::json& pareto);
/// Empty where the sweep names no errors.
std::string within_table(const nlohmann::json& pareto);
std::string time_table(const nlohmann::json& pareto);
std::string error_table(const nlohmann::json& pareto);
/// Passes of the front's points side by side: where the milliseconds go. Empty where none was
/// timed.
std::string pass_table(const nlohmann::json& pareto);

}  // namespace foverig::sweep
