#pragma once
#include <cstddef>
#include <optional>
#include <vector>

namespace foverig::sweep {

/// What a point costs and how wrong it is; less is better of both.
struct Place {
    double ms = 0.0;
    double error = 0.0;
};

/// Indices of the places that no other one beats in both, cheapest first; of equal ones the first.
std::vector<std::size_t> front_of(const std::vector<Place>& places);

/// The cheapest place of the front whose error is at most that; no value where none is.
std::optional<std::size_t> cheapest_within(const std::vector<Place>& places,
                                           const std::vector<std::size_t>& front, double error);

}  // namespace foverig::sweep
