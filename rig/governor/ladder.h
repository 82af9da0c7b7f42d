#pragma once
// The settings that a governor walks, from a scenario's `governor` section.
#include <optional>
#include <string>
#include <vector>

#include "rig/scenario/scenario.h"

namespace foverig::governor {

struct Rung {
    std::string text;  ///< "foveation.p_min = 0.05, ..."
    RenderSettings render;
    double ms = 0.0;              ///< what it cost where it was measured
    std::optional<double> error;  ///< where a sweep has measured it
};

/// Some need a renderer of their own, hence memory.
inline constexpr std::size_t kMostRungs = 16;

struct Ladder {
    std::vector<Rung> rungs;  ///< cheapest first
    std::string error_name;   ///< empty: errors are not known
};

/// No value where the scenario has no governor. Throws UsageError where its settings cannot be,
/// where they change more than the renderer, or where there are more than kMostRungs; InputError
/// where the front's file cannot be read.
std::optional<Ladder> read_ladder(const Scenario& scenario);

}  // namespace foverig::governor
