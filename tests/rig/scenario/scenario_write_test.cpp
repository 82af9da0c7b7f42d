#include "rig/scenario/write.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "rig/scenario/keys.h"
#include "rig/scenario/parse.h"

namespace foverig {
namespace {

Scenario unusual_scenario() {
    Scenario s;
    apply_toml(s, R"(
        scene = "a \"quoted\" \\ name\n.obj"
        scene_scale = 0.001
        cost = "fixed:0.1"
        seed = 4294967295
        camera.position_m = [0.1, 1e-7, -3e20]
        camera.target_m = [0, 0, 0]
        images.frames = [1, 5]
        foveation.r0_deg = 0.30000000000000004
        effects.post_process = "off"
        faults.gaze.blink = 14
        faults.panel.vsync_jitter = 12.5
    )",
               "test");
    return s;
}

TEST(ResolvedScenario, ReadsBackToTheSameScenario) {
    const std::string text = scenario_toml(unusual_scenario());
    Scenario again;
    apply_toml(again, text, "resolved");
    EXPECT_EQ(scenario_toml(again), text);
    EXPECT_EQ(again.scene, "a \"quoted\" \\ name\n.obj");
    EXPECT_EQ(again.render.foveation.r0_deg, 0.30000000000000004);
    EXPECT_EQ(again.render.seed, 4294967295U);
    EXPECT_EQ(again.camera.position_m, (std::vector<double>{0.1, 1e-7, -3e20}));
    EXPECT_EQ(again.faults.gaze.blink, 14.0);
    EXPECT_EQ(again.faults.panel.vsync_jitter, 12.5);
}

TEST(ResolvedScenario, HoldsEveryKeyButFaultsThatAreOff) {
    const std::string text = scenario_toml(Scenario{});
    EXPECT_THAT(text, testing::HasSubstr("epsilon_grazing = "));
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("[faults")));
}

TEST(ResolvedScenario, IsNestedByTheDotsInJson) {
    const auto json = scenario_json(unusual_scenario());
    EXPECT_EQ(json["foveation"]["configuration"], "custom");
    EXPECT_EQ(json["faults"]["gaze"]["blink"], 14.0);
    EXPECT_FALSE(json["faults"].contains("dk2"));
    EXPECT_EQ(json["images"]["frames"], (std::vector<int>{1, 5}));
}

TEST(ScenarioKeys, HaveUniqueNamesAndOneLineOfHelp) {
    std::vector<std::string> names;
    for (const Key& key : scenario_keys()) {
        names.push_back(key.name);
        EXPECT_FALSE(key.help.empty()) << key.name;
        EXPECT_EQ(key.help.find('\n'), std::string::npos) << key.name;
    }
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

TEST(ScenarioKeys, AcceptTheirOwnDefaults) {
    const Scenario defaults;
    for (const Key& key : scenario_keys()) {
        Scenario copy;
        EXPECT_FALSE(key.set(copy, key.get(defaults)).has_value()) << key.name;
    }
}

TEST(ScenarioHelp, ListsTheKeysThatOthersRelyOn) {
    const std::string help = scenario_help();
    for (const char* key :
         {"scene = ", "pipeline = ", "seed = ", "display.rate_hz = ", "display.eye_width_px = ",
          "foveation.p_min = ", "lighting.area_lights = ", "effects.post_process = ",
          "recording.enabled = ", "motion.gaze = ", "camera.target_m = ", "faults.dk2.noise = "}) {
        EXPECT_THAT(help, testing::HasSubstr(key));
    }
}

}  // namespace
}  // namespace foverig
