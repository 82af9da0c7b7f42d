#include "rig/governor/ladder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "rig/failure.h"

namespace foverig::governor {
namespace {

using testing::HasSubstr;

Scenario with(const std::string& settings) {
    Scenario scenario;
    scenario.governor.settings = settings;
    return scenario;
}

std::string complaint_of(const Scenario& scenario) {
    try {
        read_ladder(scenario);
    } catch (const UsageError& error) {
        return error.what();
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

TEST(Ladder, IsNotThereUnlessAskedFor) {
    EXPECT_FALSE(read_ladder(Scenario{}));
}

TEST(Ladder, TakesSettingsInlineAndPutsTheCheapestFirst) {
    const auto ladder = read_ladder(
        with("9: foveation.p_min = 0.05, lighting.area_samples = 4; 4.5: foveation.p_min=0.01;"
             " 20: pipeline = full"));
    ASSERT_TRUE(ladder);
    ASSERT_EQ(ladder->rungs.size(), 3U);
    EXPECT_EQ(ladder->rungs[0].ms, 4.5);
    EXPECT_EQ(ladder->rungs[0].render.foveation.p_min, 0.01);
    EXPECT_EQ(ladder->rungs[1].text, "foveation.p_min = 0.05, lighting.area_samples = 4");
    EXPECT_EQ(ladder->rungs[1].render.lighting.area_samples, 4);
    EXPECT_EQ(ladder->rungs[2].render.pipeline, "full");
    EXPECT_FALSE(ladder->rungs[0].error);
}

TEST(Ladder, RefusesWhatCannotBe) {
    EXPECT_THAT(complaint_of(with("foveation.p_min = 0.1")), HasSubstr("expected \"MS:"));
    EXPECT_THAT(complaint_of(with("-3: foveation.p_min = 0.1")), HasSubstr("expected \"MS:"));
    EXPECT_THAT(complaint_of(with("3: foveation.p_min")), HasSubstr("expected KEY = VALUE"));
    EXPECT_THAT(complaint_of(with("3: foveation.p_mim = 0.1")), HasSubstr("foveation.p_min"));
    EXPECT_THAT(complaint_of(with("3: foveation.p_min = 7")), HasSubstr("from 0 to 1"));
    EXPECT_THAT(complaint_of(with("3: display.eye_width_px = 99")),
                HasSubstr("the renderer alone"));
    std::string many = "1: seed = 1";
    for (int i = 2; i < 19; ++i) many += "; " + std::to_string(i) + ": seed = 1";
    EXPECT_THAT(complaint_of(with(many)), HasSubstr("18 settings; expected 1 to 16"));
    Scenario both = with("3: seed = 1");
    both.governor.front = "pareto.json";
    EXPECT_THAT(complaint_of(both), HasSubstr("expected one"));
}

TEST(Ladder, TakesTheFrontOfASweep) {
    const auto file = std::filesystem::path(testing::TempDir()) /
                      ("ladder_test_" + std::to_string(getpid()) + ".json");
    Scenario scenario;
    scenario.governor.front = file.string();
    EXPECT_THAT(complaint_of(scenario), HasSubstr("expected the pareto.json of a sweep"));
    std::ofstream(file) << R"({"schema": "foverig.pareto/1", "front": []})";
    EXPECT_THAT(complaint_of(scenario), HasSubstr("is not as a sweep writes it"));
    std::ofstream(file) << R"({"schema": "foverig.pareto/1", "cases": [], "front": []})";
    EXPECT_THAT(complaint_of(scenario), HasSubstr("shows several scenes"));
    std::ofstream(file) << R"({"schema": "foverig.pareto/1", "error": "acuity",
        "points": [{"settings": {"foveation.p_min": 0.3}}, {"settings": {"foveation.p_min": 0.01}}],
        "front": [{"point": 1, "time_ms": 5.5, "error": 0.02},
                  {"point": 0, "time_ms": 11.0, "error": 0.01}]})";
    const auto ladder = read_ladder(scenario);
    std::filesystem::remove(file);
    ASSERT_TRUE(ladder);
    ASSERT_EQ(ladder->rungs.size(), 2U);
    EXPECT_EQ(ladder->error_name, "acuity");
    EXPECT_EQ(ladder->rungs[0].render.foveation.p_min, 0.01);
    EXPECT_EQ(ladder->rungs[0].error, 0.02);
    EXPECT_EQ(ladder->rungs[1].ms, 11.0);
}

}  // namespace
}  // namespace foverig::governor
