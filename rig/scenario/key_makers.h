#pragma once
// Rows of the key table. `at` is a generic lambda `[](auto& s) -> auto&` that names the field, so
// that one accessor serves reading and writing.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "rig/scenario/keys.h"

namespace foverig {

struct Range {
    double min = 0.0;
    double max = std::numeric_limits<double>::infinity();
};

inline std::string range_text(const Range& range, const std::string& unit) {
    const std::string of = unit.empty() ? "" : fmt::format(" ({})", unit);
    return range.max < std::numeric_limits<double>::infinity()
               ? fmt::format(" from {} to {}{}", range.min, range.max, of)
               : fmt::format(" of at least {}{}", range.min, of);
}

inline std::string joined(const std::vector<std::string>& words, const char* separator = ", ") {
    return fmt::format("{}", fmt::join(words, separator));
}

template <class Access>
Key flag_key(std::string name, std::string help, Access at) {
    return {.name = std::move(name),
            .type = KeyType::flag,
            .expected = "true or false",
            .help = std::move(help),
            .get = [at](const Scenario& s) { return KeyValue(at(s)); },
            .set = [at](Scenario& s, const KeyValue& v) -> std::optional<std::string> {
                at(s) = std::get<bool>(v);
                return std::nullopt;
            }};
}

template <class Access>
Key number_key(std::string name, const std::string& unit, Range range, std::string help,
               Access at) {
    std::string expected = "a number" + range_text(range, unit);
    return {
        .name = std::move(name),
        .type = KeyType::number,
        .expected = expected,
        .help = std::move(help),
        .get = [at](const Scenario& s) { return KeyValue(static_cast<double>(at(s))); },
        .set = [at, range, expected](Scenario& s, const KeyValue& v) -> std::optional<std::string> {
            const double value = std::get<double>(v);
            if (!(value >= range.min && value <= range.max)) return expected;
            at(s) = value;
            return std::nullopt;
        }};
}

template <class Access>
Key integer_key(std::string name, const std::string& unit, Range range, std::string help,
                Access at) {
    std::string expected = "a whole number" + range_text(range, unit);
    return {
        .name = std::move(name),
        .type = KeyType::integer,
        .expected = expected,
        .help = std::move(help),
        .get = [at](const Scenario& s) { return KeyValue(static_cast<std::int64_t>(at(s))); },
        .set = [at, range, expected](Scenario& s, const KeyValue& v) -> std::optional<std::string> {
            const auto value = std::get<std::int64_t>(v);
            const auto as_number = static_cast<double>(value);
            if (!(as_number >= range.min && as_number <= range.max)) return expected;
            at(s) = static_cast<std::decay_t<decltype(at(s))>>(value);
            return std::nullopt;
        }};
}

template <class Access>
Key text_key(std::string name, std::string expected, std::string help, Access at) {
    return {.name = std::move(name),
            .type = KeyType::text,
            .expected = std::move(expected),
            .help = std::move(help),
            .get = [at](const Scenario& s) { return KeyValue(at(s)); },
            .set = [at](Scenario& s, const KeyValue& v) -> std::optional<std::string> {
                at(s) = std::get<std::string>(v);
                return std::nullopt;
            }};
}

template <class Access>
Key choice_key(std::string name, std::vector<std::string> choices, std::string help, Access at) {
    Key key = text_key(std::move(name), "one of " + joined(choices), std::move(help), at);
    key.set = [at, choices = std::move(choices), expected = key.expected](
                  Scenario& s, const KeyValue& v) -> std::optional<std::string> {
        const auto& value = std::get<std::string>(v);
        if (std::find(choices.begin(), choices.end(), value) == choices.end()) return expected;
        at(s) = value;
        return std::nullopt;
    };
    return key;
}

/// Numbers in groups of `group`, or [].
template <class Access>
Key numbers_key(std::string name, std::size_t group, std::string expected, std::string help,
                Access at) {
    return {
        .name = std::move(name),
        .type = KeyType::numbers,
        .expected = expected,
        .help = std::move(help),
        .get = [at](const Scenario& s) { return KeyValue(at(s)); },
        .set = [at, group, expected](Scenario& s, const KeyValue& v) -> std::optional<std::string> {
            const auto& value = std::get<std::vector<double>>(v);
            if (value.size() % group != 0) return expected;
            at(s) = value;
            return std::nullopt;
        }};
}

/// A point [x, y, z], or [] for "from the scene".
template <class Access>
Key point_key(std::string name, std::string help, Access at) {
    Key key =
        numbers_key(std::move(name), 3, "three numbers [x, y, z] (m), or [] for the scene's own",
                    std::move(help), at);
    key.set = [at, expected = key.expected](Scenario& s,
                                            const KeyValue& v) -> std::optional<std::string> {
        const auto& value = std::get<std::vector<double>>(v);
        if (!value.empty() && value.size() != 3) return expected;
        at(s) = value;
        return std::nullopt;
    };
    return key;
}

}  // namespace foverig
