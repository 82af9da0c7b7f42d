#pragma once
// What each effect of the plan costs and what it buys: the base against itself with one left out.
#include <nlohmann/json.hpp>

#include "renderer/effects/plan.h"
#include "rig/sweep/definition.h"
#include "rig/sweep/merged.h"

namespace foverig::sweep {

/// A point for each effect that the base's plan turns on and that can be left out: by
/// effects.NAME = off; reprojection by pipeline = full. What follows from another effect has none.
void add_price_points(Sweep& sweep, const EffectPlan& plan);

/// How many of a definition's points are the design's; those of prices lie behind them.
std::size_t design_points(const nlohmann::json& definition);

/// [{effect, left_out, ms, error, error_per_ms}]: milliseconds that the effect adds and
/// error of the sweep's axis that it removes, each {value, ci95}: of runs paired in their order and
/// of frames paired with themselves. ms is null at fixed cost. Dearest first.
nlohmann::ordered_json prices_json(const Measured& measured);

}  // namespace foverig::sweep
