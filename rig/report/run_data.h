#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "rig/records/frames_csv.h"

namespace foverig::report {

/// A run folder as it was written: all that a report may be made from.
struct RunData {
    std::filesystem::path folder;
    nlohmann::json summary;
    FrameTable frames;

    /// A number of the summary by the names on its way; no value where it is absent or null.
    std::optional<double> number(std::initializer_list<const char*> path) const;
    std::string text(std::initializer_list<const char*> path) const;
};

/// Throws InputError where the folder is not one of ours.
RunData read_run(const std::filesystem::path& folder);

}  // namespace foverig::report
