// `foverig sweep` as its users meet it, at fixed cost: what it leaves depends on the program alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "tests/rig/program_bench.h"

namespace foverig {
namespace {

using test::foverig;
using test::Outcome;
using test::same_bytes;
using test::text_of;
using testing::HasSubstr;
namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::string kSmoke = FOVERIG_SOURCE_DIR "/sweeps/smoke.toml";

class ProgramSweep : public test::ProgramBench {
  protected:
    std::string place(const fs::path& name) const { return (root_ / name).string(); }

    Outcome smoke(const fs::path& out, std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments{"sweep", kSmoke, "--out", place(out)};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return foverig(arguments);
    }
    Json pareto(const fs::path& out) const {
        return Json::parse(text_of(root_ / out / "pareto.json"));
    }

    void expect_same_result(const fs::path& a, const fs::path& b) const {
        EXPECT_TRUE(same_bytes(root_ / a / "pareto.json", root_ / b / "pareto.json"));
        EXPECT_TRUE(same_bytes(root_ / a / "pareto.html", root_ / b / "pareto.html"));
    }
};

TEST_F(ProgramSweep, FindsThatMoreSamplesAreNearerToTheReference) {
    const Outcome outcome = smoke("a", {"--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("pareto.html"));
    const Json result = pareto("a");
    EXPECT_EQ(result["schema"], "foverig.pareto/1");
    EXPECT_EQ(result["modelled"], true);
    ASSERT_EQ(result["points"].size(), 6U);
    const auto error = [&](int point, const char* name) {
        return result["points"][point]["error"][name]["mean"].get<double>();
    };
    for (const int p_min : {0, 2, 4}) {
        for (const char* name : {"absolute", "flip", "acuity", "flip_acuity", "change", "flicker"})
            EXPECT_GT(error(p_min, name), error(p_min + 1, name)) << name;  // 1 lamp sample, 8
        EXPECT_LT(result["points"][p_min]["rays"]["shadow"],
                  result["points"][p_min + 1]["rays"]["shadow"]);
    }
    EXPECT_GT(error(1, "flip"), error(5, "flip")) << "fewer pixels in the periphery";
    EXPECT_EQ(result["points"][3]["default"], true);
    EXPECT_EQ(result["points"][0]["time_ms"]["value"], 9.0);
    EXPECT_TRUE(result["points"][0]["time_ms"]["ci95"].is_null()) << "nothing to estimate";
    EXPECT_EQ(result["front"].size(), 1U) << "all cost the same";
    EXPECT_EQ(result["front"][0]["point"], 5);
    EXPECT_TRUE(result["cheapest_within"][1]["point"].is_null());
}

TEST_F(ProgramSweep, AsksFovVideoVdpWhereItIsTheError) {
    ASSERT_EQ(smoke("plain").code, 0);
    std::ofstream(root_ / "seen.toml")
        << std::regex_replace(text_of(kSmoke), std::regex("error = \"flip\""), "error = \"fvvdp\"");
    ASSERT_EQ(foverig({"sweep", place("seen.toml"), "--out", place("seen")}).code, 0);
    const Json seen = pareto("seen")["points"];
    const Json plain = pareto("plain")["points"];
    for (std::size_t point = 0; point < seen.size(); ++point) {
        EXPECT_GT(seen[point]["error"]["fvvdp"]["mean"], 0.0);
        EXPECT_LT(seen[point]["error"]["fvvdp"]["mean"], 10.0);
        EXPECT_FALSE(plain[point]["error"].contains("fvvdp")) << "it takes long";
        EXPECT_EQ(seen[point]["error"]["flicker"], plain[point]["error"]["flicker"]);
    }
    EXPECT_GT(seen[0]["error"]["fvvdp"]["mean"], seen[5]["error"]["fvvdp"]["mean"]);
    EXPECT_THAT(text_of(root_ / "seen/pareto.html"), HasSubstr("10 less the JOD"));
}

TEST_F(ProgramSweep, KilledAnywhereAndResumedGivesTheSameBytes) {
    ASSERT_EQ(smoke("whole").code, 0);
    const std::string lines = text_of(root_ / "whole/runs.jsonl");
    std::size_t third_line = 0;
    for (int i = 0; i < 3; ++i) third_line = lines.find('\n', third_line) + 1;
    for (const std::size_t bytes : {std::size_t{7}, third_line, third_line + 100}) {
        fs::remove_all(root_ / "killed");
        fs::create_directories(root_ / "killed");
        std::ofstream(root_ / "killed/runs.jsonl") << lines.substr(0, bytes);
        const Outcome resumed = smoke("killed");
        ASSERT_EQ(resumed.code, 0) << resumed.err;
        const bool done_before = resumed.err.find("2 of them done before") != std::string::npos;
        EXPECT_EQ(done_before, bytes >= third_line) << resumed.err;
        EXPECT_TRUE(same_bytes(root_ / "killed/runs.jsonl", root_ / "whole/runs.jsonl"));
        expect_same_result("killed", "whole");
    }
    const Outcome again = smoke("killed");
    EXPECT_THAT(again.err, HasSubstr("6 of them done before"));
    expect_same_result("killed", "whole");
}

TEST_F(ProgramSweep, InTwoShardsGivesTheSameBytes) {
    ASSERT_EQ(smoke("whole").code, 0);
    const Outcome first = smoke("shards", {"--shard", "0/2"});
    ASSERT_EQ(first.code, 0) << first.err;
    EXPECT_THAT(first.out, HasSubstr("measured: 3 of 6 points"));
    const Outcome early = foverig({"report", place("shards")});
    EXPECT_EQ(early.code, 3);
    EXPECT_THAT(early.err, HasSubstr("3 of 6 points are not measured yet (1, 3, 5)"));
    ASSERT_EQ(smoke("shards", {"--shard", "1/2"}).code, 0);
    expect_same_result("shards", "whole");
    fs::remove(root_ / "shards/pareto.json");
    ASSERT_EQ(foverig({"report", place("shards")}).code, 0);
    expect_same_result("shards", "whole");
}

// Begun as a shard, finished without: what both files hold counts once.
TEST_F(ProgramSweep, CountsARunOnceThatTwoShardingsMeasured) {
    std::string text = text_of(kSmoke);
    text = "repetitions = 2\n" + std::regex_replace(text, std::regex("cost = \"fixed:9\""), "");
    text = std::regex_replace(text, std::regex("0\\.02, 0\\.05, 0\\.3"), "0.05");
    std::ofstream(root_ / "timed.toml") << text;
    const auto sweep = [&](const char* shard) {
        return foverig({"sweep", place("timed.toml"), "--out", place("t"), "--shard", shard});
    };
    ASSERT_EQ(sweep("0/2").code, 0);
    const Outcome whole = sweep("0/1");
    ASSERT_EQ(whole.code, 0) << whole.err;
    EXPECT_THAT(whole.out, HasSubstr("pareto.html")) << whole.out;
    EXPECT_EQ(pareto("t")["points"][0]["time_ms"]["runs"].size(), 2U);
    EXPECT_EQ(foverig({"report", place("t")}).code, 0);
}

TEST_F(ProgramSweep, RendersTheReferenceOnce) {
    ASSERT_EQ(smoke("a").code, 0);
    const auto count = [&] {
        return std::distance(fs::directory_iterator(root_ / "a/reference"),
                             fs::directory_iterator());
    };
    EXPECT_EQ(count(), 1);
    fs::remove(root_ / "a/runs.jsonl");
    const Outcome again = smoke("a");
    EXPECT_THAT(again.err, testing::Not(HasSubstr("reference: frame")));
    EXPECT_EQ(count(), 1);
}

// Is the reference good enough? Where it is, twice its samples say the same.
TEST_F(ProgramSweep, MovesNoPointBeyondItsIntervalWhereTheReferencesSamplesAreDoubled) {
    const std::string text =
        std::regex_replace(text_of(kSmoke), std::regex("\\nframes = 8"),
                           "\nframes = 60\nmotion.head = \"still\"\nmotion.gaze = \"still\"\n"
                           "camera.path = \"still\"");
    const auto sweep = [&](const std::string& name, const std::string& samples) {
        std::ofstream(root_ / (name + ".toml")) << std::regex_replace(
            text, std::regex("area_samples = 64"), "area_samples = " + samples);
        const Outcome outcome = foverig({"sweep", place(name + ".toml"), "--out", place(name)});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return pareto(name);
    };
    const Json once = sweep("once", "64");
    const Json twice = sweep("twice", "128");
    int judged = 0;
    for (std::size_t point = 0; point < once["points"].size(); ++point)
        for (const auto& [name, error] : once["points"][point]["error"].items()) {
            if (error["ci95"].is_null()) continue;
            const double moved = twice["points"][point]["error"][name]["mean"];
            EXPECT_GE(moved, error["ci95"][0].get<double>()) << point << ' ' << name;
            EXPECT_LE(moved, error["ci95"][1].get<double>()) << point << ' ' << name;
            ++judged;
        }
    EXPECT_GT(judged, 20) << "too few frames for intervals";
    ASSERT_EQ(once["front"].size(), twice["front"].size());
    for (std::size_t i = 0; i < once["front"].size(); ++i)
        EXPECT_EQ(once["front"][i]["point"], twice["front"][i]["point"]);
}

TEST_F(ProgramSweep, RefusesToGoOnWithSomethingElse) {
    ASSERT_EQ(smoke("a", {"--shard", "0/6"}).code, 0);
    std::string text = text_of(kSmoke);
    text.replace(text.find("0.3"), 3, "0.4");
    std::ofstream(root_ / "smoke.toml") << text;
    const Outcome other =
        foverig({"sweep", place("smoke.toml"), "--out", place("a"), "--shard", "0/6"});
    EXPECT_EQ(other.code, 2);
    EXPECT_THAT(other.err, HasSubstr("was begun of another sweep"));
    ASSERT_EQ(foverig({"sweep", place("smoke.toml"), "--out", place("a"), "--shard", "1/6"}).code,
              3);
    EXPECT_EQ(foverig({"report", place("a")}).code, 3);
}

// And not after hours, when the first point that has it comes.
TEST_F(ProgramSweep, RefusesASceneThatIsNotThereBeforeItMeasuresAnything) {
    for (const auto& [scene, code] : {std::pair("nowhere.glb", 3), std::pair("cornel", 2)}) {
        std::string text = text_of(kSmoke);
        const std::string knobs = "[knobs]\n";
        text.insert(text.find(knobs) + knobs.size(),
                    "scene = [\"cornell\", \"" + std::string(scene) + "\"]\n");
        std::ofstream(root_ / "scenes.toml") << text;
        for (const char* command : {"sweep", "tune"}) {
            const Outcome outcome =
                foverig({command, place("scenes.toml"), "--out", place("none")});
            EXPECT_EQ(outcome.code, code) << command;
            EXPECT_THAT(outcome.err, HasSubstr(scene));
            EXPECT_FALSE(fs::exists(root_ / "none")) << command;
        }
    }
}

TEST_F(ProgramSweep, SaysWhatIsDamaged) {
    ASSERT_EQ(smoke("a").code, 0);
    std::string lines = text_of(root_ / "a/runs.jsonl");
    lines.erase(lines.find('\n') + 20, 30);
    std::ofstream(root_ / "a/runs.jsonl") << lines;
    for (const Outcome& outcome : {smoke("a"), foverig({"report", place("a")})}) {
        EXPECT_EQ(outcome.code, 3);
        EXPECT_THAT(outcome.err,
                    testing::MatchesRegex("foverig: [^\n]*runs.jsonl:2: not a line[^\n]+\n"));
    }
    EXPECT_EQ(foverig({"sweep", place("missing.toml")}).code, 2);
    EXPECT_EQ(foverig({"sweep", kSmoke, "--shard", "2/2"}).code, 2);
    EXPECT_EQ(foverig({"sweep", kSmoke, "--out", kSmoke}).code, 2);
}

TEST_F(ProgramSweep, MeasuresTimesWhereCostIsMeasured) {
    std::string text = text_of(kSmoke);
    text = "repetitions = 2\n" + std::regex_replace(text, std::regex("cost = \"fixed:9\""), "");
    text = std::regex_replace(text, std::regex("0\\.02, 0\\.05, 0\\.3"), "0.05");
    std::ofstream(root_ / "timed.toml") << text;
    const Outcome outcome = foverig({"sweep", place("timed.toml"), "--out", place("t")});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Json result = pareto("t");
    for (const Json& point : result["points"]) {
        EXPECT_EQ(point["time_ms"]["runs"].size(), 2U);
        EXPECT_GT(point["time_ms"]["value"], 0.0);
        EXPECT_EQ(point["time_ms"]["ci95"].size(), 2U);
        EXPECT_GT(point["pass_time_ms"]["trace_primary"], 0.0);
        EXPECT_GT(point["memory"]["backend_bytes"], 0);
    }
    EXPECT_THAT(text_of(root_ / "t/pareto.html"), HasSubstr("VSync, 13.3 ms"));
    EXPECT_THAT(text_of(root_ / "t/pareto.html"), testing::Not(HasSubstr("://")));
}

}  // namespace
}  // namespace foverig
