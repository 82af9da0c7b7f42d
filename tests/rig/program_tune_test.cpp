// `foverig tune` as its users meet it, at fixed cost: the way it goes depends on the program alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/rig/program_bench.h"

namespace foverig {
namespace {

using test::foverig;
using test::Outcome;
using test::same_bytes;
using test::text_of;
using testing::HasSubstr;
using Json = nlohmann::json;
namespace fs = std::filesystem;

const std::string kSmoke = FOVERIG_SOURCE_DIR "/sweeps/smoke.toml";

class ProgramTune : public test::ProgramBench {
  protected:
    std::string place(const fs::path& name) const { return (root_ / name).string(); }

    Outcome tune(const fs::path& out, std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments{"tune", kSmoke, "--out", place(out)};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return foverig(arguments);
    }
    Json tuned(const fs::path& out) const {
        return Json::parse(text_of(root_ / out / "tuned.json"));
    }
};

TEST_F(ProgramTune, FindsTheSettingWithTheLeastErrorOfTheSweepItSpares) {
    const Outcome outcome = tune("a");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    ASSERT_EQ(foverig({"sweep", kSmoke, "--out", place("sweep")}).code, 0);
    const Json pareto = Json::parse(text_of(root_ / "sweep/pareto.json"));
    const Json best = pareto["points"][pareto["front"][0]["point"].get<std::size_t>()];
    EXPECT_EQ(tuned("a")["best"]["settings"], best["settings"]);
    EXPECT_EQ(tuned("a")["best"]["error"], best["error"]["flip"]["mean"]);
    EXPECT_LE(tuned("a")["steps"].size(), pareto["points"].size());
}

TEST_F(ProgramTune, WritesAScenarioThatRunTakes) {
    ASSERT_EQ(tune("a").code, 0);
    const Outcome run =
        foverig({"run", place("a/tuned.toml"), "--out", place("run"), "--set", "images.count=0"});
    ASSERT_EQ(run.code, 0) << run.err;
    const Json summary = Json::parse(text_of(root_ / "run/summary.json"));
    const Json settings = tuned("a")["best"]["settings"];
    EXPECT_EQ(summary["scenario"]["foveation"]["p_min"], settings["foveation.p_min"]);
    EXPECT_EQ(summary["scenario"]["lighting"]["area_samples"], settings["lighting.area_samples"]);
}

TEST_F(ProgramTune, KilledAndResumedGoesTheSameWay) {
    ASSERT_EQ(tune("whole").code, 0);
    const std::string lines = text_of(root_ / "whole/tune.jsonl");
    std::size_t third_line = 0;
    for (int i = 0; i < 3; ++i) third_line = lines.find('\n', third_line) + 1;
    fs::create_directories(root_ / "killed");
    std::ofstream(root_ / "killed/tune.jsonl") << lines.substr(0, third_line + 40);
    ASSERT_EQ(tune("killed").code, 0);
    EXPECT_TRUE(same_bytes(root_ / "killed/tune.jsonl", root_ / "whole/tune.jsonl"));
    EXPECT_TRUE(same_bytes(root_ / "killed/tuned.json", root_ / "whole/tuned.json"));
    EXPECT_TRUE(same_bytes(root_ / "killed/tuned.toml", root_ / "whole/tuned.toml"));
}

TEST_F(ProgramTune, SaysWhenNothingFitsAndServesAnotherBudgetFromWhatItHas) {
    const Outcome tight = tune("a", {"--budget-ms", "8.9"});
    EXPECT_EQ(tight.code, 1);
    EXPECT_THAT(tight.out, HasSubstr("nothing fits the budget"));
    EXPECT_EQ(tuned("a")["best"]["within_budget"], false);
    EXPECT_THAT(text_of(root_ / "a/tuned.toml"), HasSubstr("as nothing that it tried fits: 9 ms"));
    EXPECT_EQ(tune("a", {"--budget-ms", "nan"}).code, 2);
    const Outcome wide = tune("a", {"--budget-ms", "9.1"});
    EXPECT_EQ(wide.code, 0) << wide.err;
    EXPECT_EQ(tuned("a")["best"]["within_budget"], true);
}

TEST_F(ProgramTune, RefusesASweepThatIsNoGrid) {
    const std::string text = text_of(kSmoke);
    for (const char* points : {"4", "5", "6"}) {  // the grid would have 6
        std::ofstream(root_ / "latin.toml")
            << text << "\n[design]\nkind = \"latin\"\npoints = " << points << "\n";
        const Outcome outcome = foverig({"tune", place("latin.toml"), "--out", place("a")});
        EXPECT_EQ(outcome.code, 2) << points;
        EXPECT_THAT(outcome.err, HasSubstr("needs design.kind"));
    }
}

TEST_F(ProgramTune, RefusesValuesThatGoUpAndDown) {
    std::string text = text_of(kSmoke);
    text.replace(text.find("0.02, 0.05, 0.3"), 15, "0.05, 0.02, 0.3");
    std::ofstream(root_ / "unordered.toml") << text;
    const Outcome outcome = foverig({"tune", place("unordered.toml"), "--out", place("a")});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("the values of foveation.p_min go up and down"));
}

}  // namespace
}  // namespace foverig
