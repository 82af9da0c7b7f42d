#pragma once
#include <optional>
#include <string>

namespace foverig {

/// What a frame costs on the lockstep clock. No value: as measured. From "measured" or "fixed:MS".
struct Cost {
    std::optional<double> fixed_ms;
};

/// No value where `text` is neither "measured" nor "fixed:" and a number from 0 to 10000 (ms).
std::optional<Cost> parse_cost(const std::string& text);

}  // namespace foverig
