#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace foverig::sweep {

/// The error over each knob that the sweep names in `over`: a static SVG each, a line for every
/// setting of the other knobs, with its legend. Of a pareto.json; empty where it names none.
std::string knob_charts(const nlohmann::json& pareto);

}  // namespace foverig::sweep
