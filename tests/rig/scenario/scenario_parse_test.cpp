#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "rig/failure.h"
#include "rig/scenario/parse.h"

namespace foverig {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string complaint_of(const std::string& toml) {
    Scenario scenario;
    try {
        apply_toml(scenario, toml, "my.toml");
        complete_scenario(scenario);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "no complaint";
}

std::string complaint_of_setting(const std::string& setting) {
    Scenario scenario;
    try {
        apply_setting(scenario, setting);
        complete_scenario(scenario);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "no complaint";
}

TEST(ScenarioParse, TakesValuesOfEveryType) {
    Scenario s;
    apply_toml(s, R"(
        scene = "tunnel-maps"
        frames = 12
        seconds = 3
        display.distortion = false
        camera.position_m = [1, 2.5, -3]
        images.frames = [4, 7]
        [lighting]
        ao_samples = 16
        [effects]
        textures = "off"
        [faults.dk2]
        dropout = 0.25
    )",
               "my.toml");
    EXPECT_EQ(s.scene, "tunnel-maps");
    EXPECT_EQ(s.frames, 12);
    EXPECT_EQ(s.seconds, 3.0);
    EXPECT_FALSE(s.display.distortion);
    EXPECT_EQ(s.camera.position_m, (std::vector<double>{1.0, 2.5, -3.0}));
    EXPECT_EQ(s.images.frames, (std::vector<std::int64_t>{4, 7}));
    EXPECT_EQ(s.render.lighting.ao_samples, 16);
    EXPECT_EQ(s.render.effects.at("textures"), "off");
    EXPECT_EQ(s.faults.dk2.dropout, 0.25);
}

TEST(ScenarioParse, NamesFileLineAndNearestKeyOfAnUnknownOne) {
    EXPECT_THAT(complaint_of("scene = \"cornell\"\n\n[foveation]\nr0_degg = 5\n"),
                AllOf(HasSubstr("my.toml:4"), HasSubstr("unknown key foveation.r0_degg"),
                      HasSubstr("nearest known key is foveation.r0_deg ")));
}

TEST(ScenarioParse, NamesLineAndExpectationOfAWrongType) {
    EXPECT_THAT(complaint_of("[display]\nrate_hz = \"fast\"\n"),
                AllOf(HasSubstr("my.toml:2"), HasSubstr("display.rate_hz is text \"fast\""),
                      HasSubstr("expected a number from 1 to 1000 (Hz)")));
}

TEST(ScenarioParse, RefusesAFractionWhereAWholeNumberIsExpected) {
    EXPECT_THAT(complaint_of("frames = 1.5\n"), HasSubstr("expected a whole number"));
}

TEST(ScenarioParse, RefusesATableWhereAValueIsExpected) {
    EXPECT_THAT(complaint_of("[scene]\nname = 1\n"), HasSubstr("scene is a table"));
}

TEST(ScenarioParse, ChecksRanges) {
    EXPECT_THAT(complaint_of("foveation.p_min = 1.5\n"), HasSubstr("from 0 to 1"));
    EXPECT_THAT(complaint_of("foveation.p_min = nan\n"), HasSubstr("from 0 to 1"));
    EXPECT_THAT(complaint_of("lighting.ao_radius_m = inf\n"), HasSubstr("expected a number"));
    EXPECT_THAT(complaint_of("images.frames = [-1]\n"), HasSubstr("at least 0"));
    EXPECT_THAT(complaint_of("camera.position_m = [1, 2]\n"), HasSubstr("[x, y, z]"));
    EXPECT_THAT(complaint_of("camera.position_m = [1, 2, 3, 4, 5, 6]\n"), HasSubstr("[x, y, z]"));
    EXPECT_THAT(complaint_of("lights.areas_m = [1, 2, 3]\n"), HasSubstr("nine numbers a light"));
    EXPECT_THAT(complaint_of("camera.path = \"keys\"\n"), HasSubstr("belong together"));
    EXPECT_THAT(complaint_of("faults.dk2.dropout = 2\n"), HasSubstr("faults.dk2.dropout"));
    EXPECT_THAT(
        complaint_of("tracking.gaze_rate_hz = 75\n"),
        HasSubstr("tracking.gaze_rate_hz is the whole number 75; expected 60, 120 or 250 (Hz)"));
    EXPECT_THAT(complaint_of("tracking.gaze_rate_hz = 60.5\n"), HasSubstr("60, 120 or 250 (Hz)"));
}

TEST(ScenarioParse, NamesTheLineOfBrokenToml) {
    EXPECT_THAT(complaint_of("scene = \"cornell\"\nframes = = 3\n"),
                AllOf(HasSubstr("my.toml:2"), HasSubstr("not valid TOML")));
}

TEST(ScenarioParse, NeverForcesAnEffect) {
    EXPECT_THAT(complaint_of("effects.alpha_mask = \"force\"\n"), HasSubstr("auto or off"));
}

TEST(ScenarioParse, TakesDevicesThatOnlyTheRunCanMiss) {
    EXPECT_EQ(complaint_of("devices = \"hardware\"\n"), "no complaint");
    EXPECT_EQ(complaint_of("devices = \"replay:a.mcap\"\n"), "no complaint");
    EXPECT_THAT(complaint_of("devices = \"wishful\"\n"), HasSubstr("sim, hardware or replay"));
    EXPECT_THAT(complaint_of("devices = \"replay:\"\n"), HasSubstr("sim, hardware or replay"));
}

TEST(ScenarioParse, LetsSingleValuesWinOverTheConfiguration) {
    Scenario s;
    apply_toml(s, "foveation.r1_deg = 40\nfoveation.configuration = \"small\"\n", "my.toml");
    EXPECT_EQ(s.render.foveation.r0_deg, 5.0);
    EXPECT_EQ(s.render.foveation.r1_deg, 40.0);
    EXPECT_EQ(s.render.foveation.p_min, 0.01);
}

TEST(ScenarioParse, HasThePapersConfigurations) {
    Scenario s;
    apply_setting(s, "foveation.configuration=large");
    EXPECT_EQ(s.render.foveation.r0_deg, 15.0);
    EXPECT_EQ(s.render.foveation.r1_deg, 30.0);
    EXPECT_EQ(s.render.foveation.p_min, 0.1);
}

TEST(ScenarioParse, ChecksKeysThatMustFitEachOther) {
    EXPECT_THAT(complaint_of("foveation.r0_deg = 30\n"), HasSubstr("r1_deg >= r0_deg"));
    EXPECT_THAT(complaint_of("clock = \"wall\"\ncost = \"fixed:5\"\n"), HasSubstr("lockstep"));
    EXPECT_THAT(complaint_of("camera.position_m = [0, 1, 2]\n"), HasSubstr("belong together"));
    EXPECT_THAT(complaint_of("cost = \"fixed:0\"\ndisplay.pacing = \"free\"\n"),
                HasSubstr("stand still"));
}

TEST(ScenarioParse, FillsInTheFramesWhereNothingEndsTheRun) {
    Scenario s;
    complete_scenario(s);
    EXPECT_EQ(s.frames, kDefaultFrames);
    Scenario timed;
    timed.seconds = 2.0;
    complete_scenario(timed);
    EXPECT_EQ(timed.frames, 0);
}

TEST(ScenarioSetting, TakesTextWithAndWithoutQuotes) {
    Scenario s;
    apply_setting(s, "scene=cornell");
    EXPECT_EQ(s.scene, "cornell");
    apply_setting(s, "scene=\"with space.obj\"");
    EXPECT_EQ(s.scene, "with space.obj");
    apply_setting(s, "scene=1234");
    EXPECT_EQ(s.scene, "1234");
    apply_setting(s, "camera.target_m=[1,2,3]");
    EXPECT_EQ(s.camera.target_m, (std::vector<double>{1, 2, 3}));
}

TEST(ScenarioSetting, SaysWhatItExpects) {
    EXPECT_THAT(complaint_of_setting("frames"), HasSubstr("expected key=value"));
    EXPECT_THAT(complaint_of_setting("frames=many"), HasSubstr("frames is text \"many\""));
    EXPECT_THAT(complaint_of_setting("sceen=cornell"), HasSubstr("nearest known key is scene "));
    EXPECT_THAT(complaint_of_setting("frames=3\nseed=4"), HasSubstr("expected a whole number"));
}

TEST(ScenarioFile, TakesARelativeSceneFromItsOwnFolder) {
    const auto folder = std::filesystem::path(testing::TempDir()) /
                        ("scenario_file_test_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "a.toml") << "scene = \"models/box.obj\"\n";
    std::ofstream(folder / "b.toml") << "scene = \"cornell\"\n";
    EXPECT_EQ(read_scenario(folder / "a.toml").scene, (folder / "models/box.obj").string());
    EXPECT_EQ(read_scenario(folder / "b.toml").scene, "cornell");
    EXPECT_THROW(read_scenario(folder / "missing.toml"), UsageError);
    EXPECT_THROW(read_scenario(folder), UsageError);
}

}  // namespace
}  // namespace foverig
