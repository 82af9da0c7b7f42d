#include "rig/records/fail_if.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "rig/failure.h"
#include "rig/text/nearest.h"

namespace foverig {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 6> kComparisons{"<", "<=", ">", ">=", "==", "!="};

std::string trimmed(std::string text) {
    text.erase(0, text.find_first_not_of(" \t"));
    text.erase(text.find_last_not_of(" \t") + 1);
    return text;
}

void collect_numbers(const json& node, const std::string& path, std::vector<std::string>& paths) {
    if (node.is_object()) {
        for (const auto& [key, value] : node.items()) {
            collect_numbers(value, path.empty() ? key : path + "." + key, paths);
        }
    } else if (node.is_number() || node.is_null()) {
        paths.push_back(path);
    }
}

/// Names may hold dots themselves (passes), so any prefix of the path may be one name. What lies
/// below null is absent, as that is.
const json* find(const json& node, const std::string& path) {
    if (!node.is_object()) return nullptr;
    if (const auto whole = node.find(path); whole != node.end()) return &*whole;
    for (auto dot = path.find('.'); dot != std::string::npos; dot = path.find('.', dot + 1)) {
        const auto inner = node.find(path.substr(0, dot));
        if (inner == node.end()) continue;
        if (inner->is_null()) return &*inner;
        if (const json* found = find(*inner, path.substr(dot + 1))) return found;
    }
    return nullptr;
}

bool holds(double value, const std::string& comparison, double bound) {
    if (comparison == "<") return value < bound;
    if (comparison == "<=") return value <= bound;
    if (comparison == ">") return value > bound;
    if (comparison == ">=") return value >= bound;
    if (comparison == "==") return value == bound;
    return value != bound;
}

}  // namespace

FailIf parse_fail_if(const std::string& text) {
    const auto sign = text.find_first_of("<>=!");
    const auto after = text.find_first_not_of("<>=!", sign);
    if (sign != std::string::npos && after != std::string::npos) {
        FailIf check{trimmed(text.substr(0, sign)), text.substr(sign, after - sign), 0.0};
        const std::string number = trimmed(text.substr(after));
        const char* const end = number.data() + number.size();
        const auto [stop, error] = std::from_chars(number.data(), end, check.bound);
        const bool is_key = !check.key.empty() && check.key.find(' ') == std::string::npos;
        const bool is_comparison = std::find(kComparisons.begin(), kComparisons.end(),
                                             check.comparison) != kComparisons.end();
        if (is_key && is_comparison && error == std::errc{} && stop == end &&
            std::isfinite(check.bound))
            return check;
    }
    throw UsageError(fmt::format(
        "--fail-if '{}': expected KEY COMPARISON NUMBER, as in 'vsync.missed_ratio > 0.01'", text));
}

std::optional<std::string> failure(const FailIf& check, const json& summary) {
    const json* value = find(summary, check.key);
    if (value != nullptr && value->is_null()) {
        return fmt::format("{} {} {}: {} is absent in this run", check.key, check.comparison,
                           check.bound, check.key);
    }
    if (value == nullptr || !value->is_number()) {
        std::vector<std::string> known;
        collect_numbers(summary, "", known);
        throw UsageError(fmt::format("--fail-if: summary.json has no number {}; the nearest is {}",
                                     check.key, nearest(check.key, known)));
    }
    const double number = value->get<double>();
    if (!holds(number, check.comparison, check.bound)) return std::nullopt;
    return fmt::format("{} {} {}: it is {}", check.key, check.comparison, check.bound, number);
}

}  // namespace foverig
