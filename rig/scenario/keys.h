#pragma once
// The one table of scenario keys. Parsing, `--set`, `--help-scenario`, the resolved scenario.toml
// and the summary's JSON all read it, so none of them can disagree.
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "rig/scenario/scenario.h"

namespace foverig {

enum class KeyType { flag, integer, number, text, numbers, integers };

using KeyValue = std::variant<bool, std::int64_t, double, std::string, std::vector<double>,
                              std::vector<std::int64_t>>;

struct Key {
    std::string name;  ///< dotted: "foveation.r0_deg"
    KeyType type = KeyType::flag;
    std::string expected;  ///< "a number from 0 to 180 (deg)"
    std::string help;      ///< one line
    std::function<KeyValue(const Scenario&)> get;
    /// Sets, or says why the value cannot be.
    std::function<std::optional<std::string>(Scenario&, const KeyValue&)> set;
    /// False: absent is different from any value, so it is written only once it was set.
    std::function<bool(const Scenario&)> present = [](const Scenario&) { return true; };
};

/// In the order of help and files.
const std::vector<Key>& scenario_keys();

/// Nullptr for an unknown name.
const Key* find_key(const std::string& name);

/// The known name that is nearest to an unknown one.
std::string nearest_key(const std::string& unknown);

}  // namespace foverig
