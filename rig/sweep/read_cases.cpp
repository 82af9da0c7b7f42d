#include "rig/sweep/read_cases.h"

#include <fmt/format.h>

#include <algorithm>

#include "rig/failure.h"
#include "rig/scenario/parse.h"
#include "rig/scenario/write.h"

namespace foverig::sweep {
namespace fs = std::filesystem;
namespace {

/// What differs from the base, as `foverig run --set` takes it.
Settings settings_from(const Scenario& base, const Scenario& scenario) {
    Settings settings;
    for (const Key& key : scenario_keys())
        if (const KeyValue value = key.get(scenario); value != key.get(base))
            settings.emplace_back(key.name, value);
    return settings;
}

/// A name that no other of them has.
std::string read_name(const fs::path& file, const toml::table& table, const TomlReader& reader,
                      std::vector<std::string>& taken) {
    const std::string name = reader.text("name", "");
    if (name.empty()) refuse(file, table, "has no name; expected name = \"...\"");
    if (std::find(taken.begin(), taken.end(), name) != taken.end())
        refuse(file, table,
               fmt::format("another one has the name {}; expected one of its own", name));
    taken.push_back(name);
    return name;
}

/// The case's scenario; where its scene's file is not there, with its [stand_in] on top.
Scenario read_scene(const fs::path& file, const toml::table& table, const TomlReader& reader,
                    const Scenario& base, std::string& note) {
    Scenario scenario = base;
    if (const auto* keys = reader.table("scenario")) apply_table(scenario, *keys, file);
    if (const auto* stand_in = reader.table("stand_in")) {
        std::error_code error;
        if (!fs::exists(scenario.scene, error)) {
            const std::string missing = scenario.scene;
            apply_table(scenario, *stand_in, file);
            if (scenario.scene == missing)
                refuse(file, table, "stand_in names no scene; expected stand_in.scene = \"...\"");
            note = fmt::format("{} is not there: {} stands in", missing, scenario.scene);
        }
    }
    complete_scenario(scenario);
    return scenario;
}

}  // namespace

RenderSettings read_reference(const fs::path& file, const toml::table* table,
                              const Scenario& base) {
    Scenario reference = base;
    reference.render.pipeline = "full";
    if (table == nullptr) return reference.render;
    apply_table(reference, *table, file);
    complete_scenario(reference);
    if (reference.render.pipeline != "full" && reference.render.pipeline != "reference")
        refuse(file, *table,
               fmt::format("the reference's pipeline is {}; expected full or reference",
                           reference.render.pipeline));
    Scenario rest = reference;
    rest.render = base.render;
    if (scenario_toml(rest) != scenario_toml(base))
        refuse(file, *table, "the reference may differ in keys of the renderer alone");
    return reference.render;
}

void read_cases(const fs::path& file, const TomlReader& reader, const toml::table* reference,
                Sweep& sweep) {
    std::vector<std::string> case_names;
    const auto variants = reader.tables("variants");
    if (variants.empty())
        throw UsageError(fmt::format(
            "{}: has cases and no variants; expected [[variants]] to try on each", file.string()));
    for (const toml::table* table : reader.tables("cases")) {
        const TomlReader of_case(file, *table, {"name", "note", "scenario", "stand_in"});
        Case shown{.name = read_name(file, *table, of_case, case_names),
                   .note = of_case.text("note", ""),
                   .reference = {}};
        const Scenario scenario = read_scene(file, *table, of_case, sweep.base, shown.note);
        shown.reference = read_reference(file, reference, scenario);
        std::vector<std::string> variant_names;
        for (const toml::table* variant : variants) {
            const TomlReader of_variant(file, *variant, {"name", "scenario"});
            Point point;
            point.variant = read_name(file, *variant, of_variant, variant_names);
            point.of_case = sweep.cases.size();
            point.scenario = scenario;
            if (const auto* keys = of_variant.table("scenario"))
                apply_table(point.scenario, *keys, file);
            complete_scenario(point.scenario);
            point.settings = settings_from(sweep.base, point.scenario);
            sweep.points.push_back(std::move(point));
        }
        sweep.cases.push_back(std::move(shown));
    }
}

}  // namespace foverig::sweep
