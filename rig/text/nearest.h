#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace foverig {

/// Levenshtein distance: insertions, deletions and substitutions that turn one into the other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate with the smallest distance, the first of equals; empty where there is none.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace foverig
