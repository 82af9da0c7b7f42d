#include "rig/scenario/parse.h"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <fstream>
#include <sstream>

#include "renderer/scene/library.h"
#include "rig/failure.h"
#include "rig/scenario/cost.h"
#include "rig/scenario/keys.h"
#include "rig/scenario/toml_value.h"

namespace foverig {
namespace {

struct Leaf {
    std::string name;
    const toml::node* value;
};

void collect_leaves(const toml::table& table, const std::string& prefix,
                    std::vector<Leaf>& leaves) {
    for (const auto& [key, node] : table) {
        const std::string name = prefix + std::string(key.str());
        // A table where a plain key is expected stays a leaf, so that it is a wrong type.
        if (const auto* inner = node.as_table(); inner != nullptr && find_key(name) == nullptr) {
            collect_leaves(*inner, name + ".", leaves);
        } else {
            leaves.push_back({name, &node});
        }
    }
}

/// File order, but the configuration first: r0_deg, r1_deg and p_min win over it.
void order_leaves(std::vector<Leaf>& leaves) {
    std::stable_sort(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) {
        return a.value->source().begin < b.value->source().begin;
    });
    std::stable_partition(leaves.begin(), leaves.end(),
                          [](const Leaf& leaf) { return leaf.name == "foveation.configuration"; });
}

void apply_leaf(Scenario& scenario, const Leaf& leaf, const std::string& where) {
    const Key* key = find_key(leaf.name);
    if (key == nullptr) {
        throw UsageError(
            fmt::format("{}: unknown key {}; the nearest known key is {} (foverig run "
                        "--help-scenario lists all)",
                        where, leaf.name, nearest_key(leaf.name)));
    }
    const auto value = value_from_toml(*leaf.value, key->type);
    const auto complaint =
        value ? key->set(scenario, *value) : std::optional<std::string>(key->expected);
    if (complaint) {
        throw UsageError(fmt::format("{}: {} is {}; expected {}", where, key->name,
                                     described(*leaf.value), *complaint));
    }
}

void apply_leaves(Scenario& scenario, const toml::table& table, const std::string& name) {
    std::vector<Leaf> leaves;
    collect_leaves(table, "", leaves);
    order_leaves(leaves);
    for (const Leaf& leaf : leaves) {
        apply_leaf(scenario, leaf, fmt::format("{}:{}", name, leaf.value->source().begin.line));
    }
}

bool is_builtin_scene(const std::string& name) {
    const auto scenes = builtin_scenes();
    return std::any_of(scenes.begin(), scenes.end(),
                       [&](const BuiltinInfo& scene) { return scene.name == name; });
}

/// A relative scene that `file` named is taken from its folder.
void find_scene_beside(const std::filesystem::path& file, const std::string& scene_before,
                       Scenario& scenario) {
    const std::filesystem::path scene = scenario.scene;
    if (scenario.scene != scene_before && !is_builtin_scene(scenario.scene) &&
        scene.is_relative()) {
        scenario.scene = (file.parent_path() / scene).lexically_normal().string();
    }
}

std::string read_text(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (!stream || std::filesystem::is_directory(file) || !(text << stream.rdbuf())) {
        throw UsageError(
            fmt::format("{}: cannot be read; expected a scenario (docs/scenarios has examples)",
                        file.string()));
    }
    return text.str();
}

}  // namespace

void apply_toml(Scenario& scenario, std::string_view text, const std::string& name) {
    toml::table table;
    try {
        table = toml::parse(text, name);
    } catch (const toml::parse_error& error) {
        throw UsageError(fmt::format("{}:{}: not valid TOML: {}", name, error.source().begin.line,
                                     error.description()));
    }
    apply_leaves(scenario, table, name);
}

void apply_table(Scenario& scenario, const toml::table& table, const std::filesystem::path& file) {
    const std::string scene_before = scenario.scene;
    apply_leaves(scenario, table, file.string());
    find_scene_beside(file, scene_before, scenario);
}

Scenario read_scenario(const std::filesystem::path& file) {
    Scenario scenario;
    const std::string default_scene = scenario.scene;
    apply_toml(scenario, read_text(file), file.string());
    find_scene_beside(file, default_scene, scenario);
    return scenario;
}

void apply_value(Scenario& scenario, const std::string& name, const std::string& text,
                 const std::string& where) {
    toml::table table;
    try {
        table = toml::parse("value = " + text);
    } catch (const toml::parse_error&) {
        table.insert_or_assign("value", text);
    }
    const Key* key = find_key(name);
    const bool bare_text =
        key != nullptr && key->type == KeyType::text && !table["value"].is_string();
    if (bare_text || table.size() != 1) {
        table.clear();
        table.insert_or_assign("value", text);
    }
    apply_leaf(scenario, {name, table.get("value")}, where);
}

void apply_setting(Scenario& scenario, const std::string& setting) {
    const auto equals = setting.find('=');
    if (equals == std::string::npos || equals == 0) {
        throw UsageError(
            fmt::format("--set {}: expected key=value, as in display.rate_hz=90", setting));
    }
    apply_value(scenario, setting.substr(0, equals), setting.substr(equals + 1),
                "--set " + setting);
}

void complete_scenario(Scenario& scenario) {
    // A window stays until it is closed.
    if (scenario.frames == 0 && scenario.seconds == 0.0 && scenario.display.kind == "virtual")
        scenario.frames = kDefaultFrames;
    const auto& foveation = scenario.render.foveation;
    if (foveation.r1_deg < foveation.r0_deg) {
        throw UsageError(fmt::format(
            "foveation.r1_deg is {} and foveation.r0_deg is {}; expected r1_deg >= r0_deg",
            foveation.r1_deg, foveation.r0_deg));
    }
    const auto& reprojection = scenario.render.reprojection;
    for (const auto& [name, k] : {std::pair{"k_min", reprojection.k_min},
                                  std::pair{"k_min_light", reprojection.k_min_light}})
        if (reprojection.k_max < k)
            throw UsageError(fmt::format(
                "reprojection.k_max is {} and reprojection.{} is {}; expected k_max >= {}",
                reprojection.k_max, name, k, name));
    if (scenario.clock == "wall" && scenario.cost != "measured") {
        throw UsageError(fmt::format(
            "cost is {} and clock is wall; a fixed cost needs clock = lockstep", scenario.cost));
    }
    const auto cost = parse_cost(scenario.cost);
    if (scenario.display.pacing == "free" && cost && cost->fixed_ms == 0.0) {
        throw UsageError(
            "cost is fixed:0 and display.pacing is free, so time would stand still; "
            "expected a cost above 0, or display.pacing = vsync");
    }
    if ((scenario.camera.path == "keys") == scenario.camera.keys_m.empty()) {
        throw UsageError(
            "camera.path = keys and camera.keys_m belong together; expected both or neither");
    }
    if (scenario.camera.position_m.empty() != scenario.camera.target_m.empty()) {
        throw UsageError(
            "camera.position_m and camera.target_m belong together; expected both or neither");
    }
    if (!scenario.see_through.distortion.empty() && !scenario.see_through.fisheye.empty()) {
        throw UsageError(
            "see_through.distortion and see_through.fisheye are two models of one lens; expected "
            "one of them");
    }
}

}  // namespace foverig
