#pragma once
// Between TOML nodes and the values of the key table.
#include <toml++/toml.h>
#include <optional>
#include <string>

#include "rig/scenario/keys.h"

namespace foverig {

/// No value where the node is of another type. A whole number is a number too.
std::optional<KeyValue> value_from_toml(const toml::node& node, KeyType type);

/// As a TOML literal that reads back to the same value.
std::string toml_literal(const KeyValue& value);

/// For complaints: `text "abc"`, `the number 1.5`, `a table`.
std::string described(const toml::node& node);

}  // namespace foverig
