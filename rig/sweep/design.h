#pragma once
// Which settings of the knobs are tried.
#include "rig/sweep/definition.h"

namespace foverig::sweep {

/// Every combination of the knobs' values, the last knob's changing fastest.
std::vector<Settings> grid(const std::vector<Knob>& knobs);

/// `count` settings such that each of as many equal parts of a knob's range, or of its list, is met
/// once (McKay, Beckman and Conover 1979); where in its part, and which parts meet, is drawn.
std::vector<Settings> latin_hypercube(const std::vector<Knob>& knobs, std::size_t count,
                                      std::uint64_t seed);

/// Numbers 0..count-1 in a drawn order; `stream` tells drawings of one seed apart.
std::vector<std::size_t> shuffled(std::size_t count, std::uint64_t seed, std::uint64_t stream);

}  // namespace foverig::sweep
