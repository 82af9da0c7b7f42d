#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

namespace foverig {

/// A key of summary.json as a person reads it: "missed_exposures" is "missed exposures".
inline std::string words(std::string key) {
    std::ranges::replace(key, '_', ' ');
    return key;
}

/// "3 control failures, 12 missed exposures" of counts by key; those of 0 are left out.
inline std::string counted(const nlohmann::json& counts) {
    std::string text;
    for (const auto& [key, count] : counts.items()) {
        if (!count.is_number_unsigned() || count == 0U) continue;
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count.get<std::uint64_t>(),
                            words(key));
    }
    return text;
}

}  // namespace foverig
