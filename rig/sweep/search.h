#pragma once
// Searches a grid of settings for the smallest error within a budget, without trying all of it.
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "rig/sweep/front.h"

namespace foverig::sweep {

/// Which value of each knob.
using GridPlace = std::vector<std::size_t>;

struct SearchStep {
    GridPlace place;
    Place found;
    bool better = false;  ///< than the best before it
};

struct SearchResult {
    std::vector<SearchStep> steps;  ///< every place, in the order of asking
    std::size_t best = 0;           ///< of them
};

/// Walks from `start`, on a grid of `sizes` values a knob that rise or fall one after the other:
/// each knob a value up or down for as long as that is better; where no single one is, a step that
/// lowers the error but is too dear, paid for by another knob's steps until it fits. Ends where
/// neither helps. Better is: within the budget instead of beyond; of two within the smaller error,
/// of equal ones the cheaper; of two beyond the cheaper. `measure` is asked once a place; its
/// answers alone decide the way.
SearchResult search(const std::vector<std::size_t>& sizes, const GridPlace& start, double budget_ms,
                    const std::function<Place(const GridPlace&)>& measure);

}  // namespace foverig::sweep
