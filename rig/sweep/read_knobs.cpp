#include "rig/sweep/read_knobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "rig/failure.h"
#include "rig/scenario/toml_value.h"
#include "rig/sweep/toml_reader.h"

namespace foverig::sweep {
namespace fs = std::filesystem;
namespace {

constexpr std::array<const char*, 5> kNoKnobs{"clock", "cost", "devices", "frames", "seconds"};

void read_range(const fs::path& file, const toml::table& range, Knob& knob) {
    const TomlReader reader(file, range, {"from", "to", "log"});
    const auto from = range["from"].value<double>();
    const auto to = range["to"].value<double>();
    knob.logarithmic = range["log"].value_or(false);
    const bool is_number = knob.key->type == KeyType::number || knob.key->type == KeyType::integer;
    const bool valid = from && to && std::isfinite(*from) && std::isfinite(*to) && *from < *to &&
                       (!knob.logarithmic || *from > 0.0);
    if (!is_number || !valid)
        refuse(
            file, range,
            fmt::format("{}: expected a list of values or, for a number, {{from = LOW, to = HIGH, "
                        "log = false}} with LOW < HIGH, above 0 where log is true",
                        knob.key->name));
    knob.from = *from;
    knob.to = *to;
}

Knob read_knob(const fs::path& file, const std::string& name, const toml::node& node) {
    Knob knob;
    knob.key = find_key(name);
    if (knob.key == nullptr)
        refuse(file, node,
               fmt::format("unknown knob {}; the nearest scenario key is {} (foverig run "
                           "--help-scenario lists all)",
                           name, nearest_key(name)));
    if (std::find(kNoKnobs.begin(), kNoKnobs.end(), name) != kNoKnobs.end())
        refuse(file, node, fmt::format("{} is no knob; every point of a sweep has the same", name));
    if (const auto* range = node.as_table()) {
        read_range(file, *range, knob);
        return knob;
    }
    const auto* values = node.as_array();
    if (values == nullptr || values->empty())
        refuse(file, node,
               fmt::format("{} has no values; expected a list of at least one, each {}", name,
                           knob.key->expected));
    for (const toml::node& element : *values) {
        const auto value = value_from_toml(element, knob.key->type);
        if (!value)
            refuse(
                file, element,
                fmt::format("{} is {}; expected {}", name, described(element), knob.key->expected));
        if (std::find(knob.values.begin(), knob.values.end(), *value) != knob.values.end())
            refuse(file, element,
                   fmt::format("{} has {} twice; expected values that differ", name,
                               described(element)));
        knob.values.push_back(*value);
    }
    return knob;
}

void collect_knobs(const fs::path& file, const toml::table& table, const std::string& prefix,
                   std::vector<std::pair<const toml::node*, Knob>>& knobs) {
    for (const auto& [key, node] : table) {
        const std::string name = prefix + std::string(key.str());
        const auto* inner = node.as_table();
        if (inner != nullptr && find_key(name) == nullptr && !inner->contains("from"))
            collect_knobs(file, *inner, name + ".", knobs);
        else
            knobs.emplace_back(&node, read_knob(file, name, node));
    }
}

}  // namespace

std::vector<Knob> read_knobs(const fs::path& file, const toml::table* table) {
    std::vector<std::pair<const toml::node*, Knob>> found;
    if (table != nullptr) collect_knobs(file, *table, "", found);
    if (found.empty())
        throw UsageError(fmt::format(
            "{}: turns no knob; expected a table [knobs] with lists of values", file.string()));
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
        return a.first->source().begin < b.first->source().begin;
    });
    std::stable_partition(found.begin(), found.end(), [](const auto& knob) {
        return knob.second.key->name == "foveation.configuration";
    });
    std::vector<Knob> knobs;
    for (auto& [node, knob] : found) knobs.push_back(std::move(knob));
    return knobs;
}

}  // namespace foverig::sweep
