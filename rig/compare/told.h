#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "rig/compare/times.h"

namespace foverig::compare {

struct PassShift {
    std::string pass;
    stats::Shift shift_ms;
};

/// Of every pass that all runs have, the largest shifts first: where a difference comes from.
std::vector<PassShift> pass_shifts(const std::vector<report::RunData>& base,
                                   const std::vector<report::RunData>& fresh,
                                   const TimeComparison& comparison, bool paired);

/// For a person: medians, warm-up, shift, the verdict with its reason, passes.
std::string told(const TimeComparison& comparison, const TimeSettings& settings,
                 const std::vector<PassShift>& passes);

/// For a program.
nlohmann::ordered_json to_json(const TimeComparison& comparison, const TimeSettings& settings,
                               const std::vector<PassShift>& passes);

}  // namespace foverig::compare
