#include "rig/scenario_options.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "renderer/scene/library.h"
#include "rig/scenario/parse.h"

namespace foverig {
namespace {

struct NamedOption {
    const char* option;
    const char* key;
    const char* value;
    const char* help;
};

constexpr std::array<NamedOption, 11> kNamed{{
    {"--scene", "scene", "NAME|FILE", "built-in scene or a file (OBJ, glTF, GLB, PLY)"},
    {"--devices", "devices", "sim|hardware|replay:FILE", "where the devices' bytes come from"},
    {"--backend", "backend", "auto|embree|cuda|host-bvh", "what traces the rays"},
    {"--pipeline", "pipeline", "NAME", "how a frame is made: reprojected, full, reference"},
    {"--display", "display.kind", "virtual|window|headset", "what shows the frames"},
    {"--gaze", "motion.gaze", "NAME|mouse|FILE.csv", "how the eyes move"},
    {"--clock", "clock", "wall|lockstep", "real time, or time that moves by each frame's cost"},
    {"--cost", "cost", "measured|fixed:MS", "that cost; fixed makes runs repeat bit for bit"},
    {"--frames", "frames", "N", "how many frames"},
    {"--seconds", "seconds", "S", "how long, on the run's clock"},
    {"--seed", "seed", "N", "of every random choice"},
}};

/// Files are named as seen from where the user stands; the resolved scenario must not depend on it.
void make_absolute(std::string& file) {
    std::error_code error;
    if (std::filesystem::exists(file, error)) file = std::filesystem::absolute(file).string();
}

}  // namespace

void ScenarioOptions::add_to(CLI::App& command) {
    command.add_option("scenario", file_, "scenario file (TOML); none: the built-in scenario")
        ->type_name("SCENARIO.toml");
    add_settings_to(command);
}

void ScenarioOptions::add_settings_to(CLI::App& command) {
    for (const NamedOption& option : kNamed) {
        command.add_option(option.option, named_[option.key], option.help)
            ->type_name(option.value)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    }
    command
        .add_option("--set", settings_, "any scenario key; may be given again (--help-scenario)")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
}

Scenario ScenarioOptions::scenario() const {
    return over(file_.empty() ? Scenario{} : read_scenario(file_));
}

Scenario ScenarioOptions::over(Scenario scenario) const {
    const auto given = [&](const char* key) { return !named_.at(key).empty(); };
    // One of the two on the command line takes the place of either in the file.
    if (given("frames") != given("seconds")) {
        scenario.frames = 0;
        scenario.seconds = 0.0;
    }
    for (const NamedOption& option : kNamed) {
        const std::string& text = named_.at(option.key);
        if (!text.empty()) {
            apply_value(scenario, option.key, text, std::string(option.option) + " " + text);
        }
    }
    // A window shows real time: whoever asks for one on the command line asks for that too.
    const bool shown = scenario.display.kind != "virtual" && given("display.kind");
    if (shown && !given("clock") && scenario.cost == "measured") scenario.clock = "wall";
    for (const std::string& setting : settings_) apply_setting(scenario, setting);
    complete_scenario(scenario);
    const auto scenes = builtin_scenes();
    const bool is_builtin =
        std::any_of(scenes.begin(), scenes.end(),
                    [&](const BuiltinInfo& scene) { return scene.name == scenario.scene; });
    if (!is_builtin) make_absolute(scenario.scene);
    make_absolute(scenario.motion.head);
    make_absolute(scenario.motion.gaze);
    make_absolute(scenario.tracking.gaze_calibration);
    if (std::string recording = replayed_file(scenario); !recording.empty()) {
        make_absolute(recording);
        scenario.devices = "replay:" + recording;
    }
    return scenario;
}

}  // namespace foverig
