#include "rig/scenario/cost.h"

#include <charconv>

namespace foverig {

std::optional<Cost> parse_cost(const std::string& text) {
    if (text == "measured") return Cost{};
    const std::string prefix = "fixed:";
    if (text.rfind(prefix, 0) != 0) return std::nullopt;
    double ms = 0.0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + prefix.size(), end, ms);
    const bool valid = error == std::errc{} && stop == end && ms >= 0.0 && ms <= 10'000.0;
    return valid ? std::optional(Cost{ms}) : std::nullopt;
}

}  // namespace foverig
