#include "rig/sweep/toml_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "rig/failure.h"
#include "rig/scenario/toml_value.h"
#include "rig/text/nearest.h"

namespace foverig::sweep {
namespace fs = std::filesystem;

void refuse(const fs::path& file, const toml::node& node, const std::string& what) {
    throw UsageError(fmt::format("{}:{}: {}", file.string(), node.source().begin.line, what));
}

TomlReader::TomlReader(const fs::path& file, const toml::table& table,
                       const std::vector<std::string>& known)
    : file_(file), table_(table) {
    for (const auto& [key, node] : table) {
        const std::string name(key.str());
        if (std::find(known.begin(), known.end(), name) == known.end())
            refuse(file, node,
                   fmt::format("unknown key {}; the nearest is {}", name, nearest(name, known)));
    }
}

std::int64_t TomlReader::integer(const char* name, std::int64_t least, std::int64_t most,
                                 std::int64_t otherwise) const {
    const toml::node* node = table_.get(name);
    if (node == nullptr) return otherwise;
    const auto* integer = node->as_integer();
    if (integer == nullptr || integer->get() < least || integer->get() > most)
        refuse(file_, *node,
               fmt::format("{} is {}; expected a whole number from {} to {}", name,
                           described(*node), least, most));
    return integer->get();
}

std::string TomlReader::choice(const char* name, const std::vector<std::string>& choices,
                               const std::string& otherwise) const {
    const toml::node* node = table_.get(name);
    if (node == nullptr) return otherwise;
    const auto* text = node->as_string();
    if (text == nullptr || std::find(choices.begin(), choices.end(), text->get()) == choices.end())
        refuse(file_, *node,
               fmt::format("{} is {}; expected one of {}", name, described(*node),
                           fmt::join(choices, ", ")));
    return text->get();
}

bool TomlReader::flag(const char* name, bool otherwise) const {
    const toml::node* node = table_.get(name);
    if (node == nullptr) return otherwise;
    if (!node->is_boolean())
        refuse(file_, *node,
               fmt::format("{} is {}; expected true or false", name, described(*node)));
    return node->as_boolean()->get();
}

std::vector<double> TomlReader::numbers(const char* name) const {
    const toml::node* node = table_.get(name);
    if (node == nullptr) return {};
    const auto value = value_from_toml(*node, KeyType::numbers);
    if (!value)
        refuse(
            file_, *node,
            fmt::format("{} is {}; expected numbers, as in [0.01, 0.02]", name, described(*node)));
    return std::get<std::vector<double>>(*value);
}

std::string TomlReader::text(const char* name, const std::string& otherwise) const {
    const toml::node* node = table_.get(name);
    if (node == nullptr) return otherwise;
    if (!node->is_string())
        refuse(file_, *node, fmt::format("{} is {}; expected text", name, described(*node)));
    return node->as_string()->get();
}

std::vector<std::string> TomlReader::texts(const char* name) const {
    const toml::node* node = table_.get(name);
    if (node == nullptr) return {};
    const auto* array = node->as_array();
    if (array == nullptr)
        refuse(file_, *node, fmt::format("{} is {}; expected texts", name, described(*node)));
    std::vector<std::string> all;
    for (const toml::node& element : *array) {
        if (!element.is_string())
            refuse(file_, element,
                   fmt::format("{} holds {}; expected texts", name, described(element)));
        all.push_back(element.as_string()->get());
    }
    return all;
}

std::optional<double> TomlReader::number(const char* name) const {
    const toml::node* node = table_.get(name);
    if (node == nullptr) return std::nullopt;
    const auto value = value_from_toml(*node, KeyType::number);
    if (!value || !(std::get<double>(*value) >= 0.0))
        refuse(file_, *node,
               fmt::format("{} is {}; expected a number of at least 0", name, described(*node)));
    return std::get<double>(*value);
}

const toml::table* TomlReader::table(const char* name) const {
    const toml::node* node = table_.get(name);
    if (node == nullptr) return nullptr;
    if (!node->is_table())
        refuse(file_, *node, fmt::format("{} is {}; expected a table", name, described(*node)));
    return node->as_table();
}

std::vector<const toml::table*> TomlReader::tables(const char* name) const {
    const toml::node* node = table_.get(name);
    if (node == nullptr) return {};
    const auto* array = node->as_array();
    std::vector<const toml::table*> all;
    if (array != nullptr)
        for (const toml::node& element : *array) all.push_back(element.as_table());
    if (all.empty() || std::find(all.begin(), all.end(), nullptr) != all.end())
        refuse(file_, *node,
               fmt::format("{} is {}; expected [[{}]] tables", name, described(*node), name));
    return all;
}

}  // namespace foverig::sweep
