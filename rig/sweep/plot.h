#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace foverig::sweep {

/// Error against time, static SVG: every point with its intervals, the front as steps, the VSync as
/// a dashed line, the default ringed. Of a pareto.json.
std::string plot(const nlohmann::json& pareto);

}  // namespace foverig::sweep
