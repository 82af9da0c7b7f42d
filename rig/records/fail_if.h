#pragma once
// `--fail-if 'vsync.missed_ratio > 0.01'`: a bound on any number of summary.json.
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace foverig {

struct FailIf {
    std::string key;         ///< dotted path into the summary
    std::string comparison;  ///< < <= > >= == !=
    double bound = 0.0;
};

/// Throws UsageError where the text is not KEY COMPARISON NUMBER.
FailIf parse_fail_if(const std::string& text);

/// Why the run fails, or nothing. A value that is absent (null) fails: it cannot be shown to hold.
/// Throws UsageError for a key that the summary does not have, naming the nearest one.
std::optional<std::string> failure(const FailIf& check, const nlohmann::json& summary);

}  // namespace foverig
