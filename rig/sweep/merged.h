#pragma once
// All that the processes of a sweep have left in its folder.
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "rig/sweep/records.h"

namespace foverig::sweep {

struct Measured {
    nlohmann::json definition;  ///< header.h
    nlohmann::json build;
    std::set<nlohmann::json> hosts;
    std::map<std::size_t, Accuracy> accuracies;       ///< by point
    std::map<std::size_t, std::vector<Times>> times;  ///< by point, in the order of repetitions

    std::size_t points() const { return definition.at("points").size(); }
    /// Points of which something is not measured yet.
    std::vector<std::size_t> missing() const;
};

/// A folder that holds what `foverig sweep` measures.
bool is_sweep(const std::filesystem::path& folder);

/// Throws InputError for damaged files, and for files of different sweeps or programs.
Measured read_measured(const std::filesystem::path& folder);

}  // namespace foverig::sweep
