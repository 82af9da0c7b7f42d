#include "rig/compare/comparable.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>

#include "rig/failure.h"
#include "rig/text/nearest.h"

namespace foverig::compare {
namespace {

using Facts = std::map<std::string, std::string>;  // dotted name -> value as JSON

constexpr const char* kAbsent = "absent";
constexpr std::size_t kMostNamed = 3;

void collect(const nlohmann::json& node, const std::string& name, Facts& facts) {
    if (!node.is_object()) {
        facts[name] = node.dump();
        return;
    }
    for (const auto& [key, value] : node.items())
        collect(value, name.empty() ? key : name + "." + key, facts);
}

/// All that must not differ. With hardware.head = auto the scenario does not say whether the
/// headset was there; what says nothing of it was made before runs did.
Facts facts_of(const nlohmann::json& summary) {
    Facts facts;
    collect(summary.value("scenario", nlohmann::json::object()), "", facts);
    constexpr std::array<std::array<const char*, 2>, 7> kBesides{{{"build", "type"},
                                                                  {"build", "fp_mode"},
                                                                  {"build", "backend"},
                                                                  {"host", "cpu"},
                                                                  {"host", "cores"},
                                                                  {"host", "gpu"},
                                                                  {"host", "os"}}};
    for (const auto& [part, key] : kBesides) {
        const auto values = summary.value(part, nlohmann::json::object());
        facts[fmt::format("{}.{}", part, key)] = values.value(key, nlohmann::json()).dump();
    }
    const auto devices = summary.value("devices", nlohmann::json::object());
    for (const auto& [name, device] : devices.items())
        if (name != "panel" && device.value("origin", "") == "hardware")
            facts[fmt::format("devices.{}.origin", name)] = device.at("origin").dump();
    return facts;
}

std::string value_in(const Facts& facts, const std::string& key) {
    const auto found = facts.find(key);
    return found == facts.end() ? kAbsent : found->second;
}

std::vector<std::string> differing(const Facts& a, const Facts& b) {
    Facts all = a;
    all.insert(b.begin(), b.end());
    std::vector<std::string> keys;
    for (const auto& [key, value] : all)
        if (value_in(a, key) != value_in(b, key)) keys.push_back(key);
    return keys;
}

void check_known(const std::vector<std::string>& allowed, const Facts& facts) {
    std::vector<std::string> known;
    for (const auto& [key, value] : facts) known.push_back(key);
    for (const std::string& key : allowed)
        if (facts.count(key) == 0)
            throw UsageError(fmt::format("--allow {}: runs have no such key; the nearest is {}",
                                         key, nearest(key, known)));
}

}  // namespace

void check_comparable(const std::vector<report::RunData>& runs,
                      const std::vector<std::string>& allowed) {
    const Facts first = facts_of(runs.front().summary);
    Facts any = first;
    for (const report::RunData& run : runs) any.merge(facts_of(run.summary));
    check_known(allowed, any);
    for (const report::RunData& run : runs) {
        const Facts facts = facts_of(run.summary);
        std::vector<std::string> keys = differing(first, facts);
        std::erase_if(keys, [&](const std::string& key) {
            return std::find(allowed.begin(), allowed.end(), key) != allowed.end();
        });
        if (keys.empty()) continue;
        std::vector<std::string> told;
        for (const std::string& key : keys)
            if (told.size() < kMostNamed)
                told.push_back(fmt::format("{} is {} and {}", key, value_in(first, key),
                                           value_in(facts, key)));
        const std::string more =
            keys.size() > kMostNamed ? fmt::format(" (and {} more)", keys.size() - kMostNamed) : "";
        throw UsageError(fmt::format(
            "{} and {} cannot be compared: {}{}; expected runs that differ in nothing but the "
            "program, or --allow {}",
            runs.front().folder.string(), run.folder.string(), fmt::join(told, ", "), more,
            fmt::join(keys, ",")));
    }
}

}  // namespace foverig::compare
