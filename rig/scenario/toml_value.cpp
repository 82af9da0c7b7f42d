#include "rig/scenario/toml_value.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace foverig {
namespace {

std::string number_literal(double value) {
    const std::string shortest = fmt::format("{}", value);
    const bool looks_whole = shortest.find_first_of(".en") == std::string::npos;
    return looks_whole ? shortest + ".0" : shortest;
}

std::string text_literal(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            quoted += '\\';
            quoted += c;
        } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
            quoted += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
        } else {
            quoted += c;
        }
    }
    return quoted + '"';
}

std::optional<double> number_of(const toml::node& node) {
    if (const auto* whole = node.as_integer()) return static_cast<double>(whole->get());
    const auto* number = node.as_floating_point();
    if (number == nullptr || !std::isfinite(number->get())) return std::nullopt;
    return number->get();
}

std::optional<KeyValue> numbers_of(const toml::array& array) {
    std::vector<double> numbers;
    for (const toml::node& element : array) {
        const auto number = number_of(element);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

std::optional<KeyValue> integers_of(const toml::array& array) {
    std::vector<std::int64_t> integers;
    for (const toml::node& element : array) {
        const auto* integer = element.as_integer();
        if (integer == nullptr) return std::nullopt;
        integers.push_back(integer->get());
    }
    return integers;
}

template <class... Cases>
struct Overloaded : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace

std::optional<KeyValue> value_from_toml(const toml::node& node, KeyType type) {
    switch (type) {
        case KeyType::flag:
            if (const auto* flag = node.as_boolean()) return flag->get();
            break;
        case KeyType::integer:
            if (const auto* integer = node.as_integer()) return integer->get();
            break;
        case KeyType::number:
            if (const auto number = number_of(node)) return *number;
            break;
        case KeyType::text:
            if (const auto* text = node.as_string()) return text->get();
            break;
        case KeyType::numbers:
            if (const auto* array = node.as_array()) return numbers_of(*array);
            break;
        case KeyType::integers:
            if (const auto* array = node.as_array()) return integers_of(*array);
            break;
    }
    return std::nullopt;
}

std::string toml_literal(const KeyValue& value) {
    return std::visit(Overloaded{
                          [](bool flag) { return std::string(flag ? "true" : "false"); },
                          [](std::int64_t integer) { return fmt::format("{}", integer); },
                          [](double number) { return number_literal(number); },
                          [](const std::string& text) { return text_literal(text); },
                          [](const std::vector<double>& numbers) {
                              std::vector<std::string> literals;
                              for (const double number : numbers)
                                  literals.push_back(number_literal(number));
                              return fmt::format("[{}]", fmt::join(literals, ", "));
                          },
                          [](const std::vector<std::int64_t>& integers) {
                              return fmt::format("[{}]", fmt::join(integers, ", "));
                          },
                      },
                      value);
}

std::string described(const toml::node& node) {
    if (const auto* text = node.as_string()) return "text " + text_literal(text->get());
    if (const auto* integer = node.as_integer())
        return fmt::format("the whole number {}", integer->get());
    if (const auto* number = node.as_floating_point())
        return fmt::format("the number {}", number->get());
    if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
    if (node.is_array()) return "an array";
    if (node.is_table()) return "a table";
    return "a date or time";
}

}  // namespace foverig
