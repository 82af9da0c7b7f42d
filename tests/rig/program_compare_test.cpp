// `foverig compare` as its users meet it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/rig/compare/synthetic_runs.h"
#include "tests/rig/program_bench.h"

namespace foverig {
namespace {

using test::foverig;
using test::Outcome;
using testing::HasSubstr;
namespace fs = std::filesystem;
using Json = nlohmann::json;

class ProgramCompare : public test::ProgramBench {
  protected:
    std::string place(const fs::path& name) const { return (root_ / name).string(); }

    void write_run(const fs::path& folder, const report::RunData& run) const {
        fs::create_directories(root_ / folder);
        const Json summary = {{"schema", "foverig.summary/1"},
                              {"scenario", {{"scene", "cornell"}, {"clock", "lockstep"}}},
                              {"build", {{"type", "Release"}, {"backend", "embree"}}},
                              {"host", {{"cpu", "Xeon"}, {"cores", 2}}}};
        std::ofstream(root_ / folder / "summary.json") << summary;
        std::ofstream csv(root_ / folder / "frames.csv");
        csv << "frame,frame_time_ms,pass.trace_ms\n";
        for (std::size_t i = 0; i < run.frames.frames; ++i)
            csv << *run.frames.column("frame")[i] << ',' << *run.frames.column("frame_time_ms")[i]
                << ',' << *run.frames.column("pass.trace_ms")[i] << '\n';
    }

    /// base/NN and new/NN.
    void write_sides(int runs, double slower) const {
        const auto sides = compare::test::in_turns({}, runs, slower);
        for (int i = 0; i < runs; ++i) {
            const auto at = static_cast<std::size_t>(i);
            write_run("base/" + std::to_string(10 + i), sides.base[at]);
            write_run("new/" + std::to_string(10 + i), sides.fresh[at]);
        }
    }
};

TEST_F(ProgramCompare, ExitsWithOneForWorseAndSaysByHowMuch) {
    write_sides(10, 1.05);
    const Outcome worse = foverig({"compare", place("base"), place("new"), "--json"});
    EXPECT_EQ(worse.code, 1) << worse.err;
    EXPECT_THAT(worse.out, HasSubstr("worse: all of the interval is beyond +3 %"));
    EXPECT_THAT(worse.out, HasSubstr("warm-up  the first"));
    EXPECT_THAT(worse.out, testing::ContainsRegex("shift    [^\n]* ms \\[[^\n]*, 95 %"));
    EXPECT_THAT(worse.out, HasSubstr("pass   trace"));
    const Json json = Json::parse(worse.out.substr(worse.out.find("\n{") + 1));
    EXPECT_EQ(json["verdict"], "worse");
    EXPECT_NEAR(json["relative_shift"]["value"].get<double>(), 0.05, 0.015);
    EXPECT_EQ(json["base"].size(), 10U);
    EXPECT_TRUE(json["runs_needed"].is_null());
}

TEST_F(ProgramCompare, ExitsWithZeroForAllElse) {
    write_sides(10, 1.05);
    const Outcome better = foverig({"compare", place("new"), place("base")});
    EXPECT_EQ(better.code, 0);
    EXPECT_THAT(better.out, HasSubstr("better: "));
    const Outcome same = foverig({"compare", place("base"), place("base")});
    EXPECT_EQ(same.code, 0);
    EXPECT_THAT(same.out, HasSubstr("same: "));
    const Outcome wide = foverig({"compare", place("base"), place("new"), "--threshold", "5"});
    EXPECT_EQ(wide.code, 0);
    EXPECT_THAT(wide.out, HasSubstr("cannot tell: the interval holds +5 %"));
    const Outcome two = foverig({"compare", place("base/10"), place("new/10")});
    EXPECT_EQ(two.code, 0);
    EXPECT_THAT(two.out, HasSubstr("cannot tell: too few runs; at least 4 a side"));
    EXPECT_THAT(two.out, testing::Not(HasSubstr("95 %"))) << "there is no interval";
}

TEST_F(ProgramCompare, TakesRunsOfEachSideByName) {
    write_sides(6, 1.05);
    std::vector<std::string> arguments{"compare"};
    for (int i = 10; i < 16; ++i) arguments.push_back(place("base/" + std::to_string(i)));
    arguments.push_back("--against");
    for (int i = 10; i < 16; ++i) arguments.push_back(place("new/" + std::to_string(i)));
    arguments.push_back("--paired");
    const Outcome worse = foverig(arguments);
    EXPECT_EQ(worse.code, 1) << worse.err;
    EXPECT_THAT(worse.out, HasSubstr("6 runs"));
}

TEST_F(ProgramCompare, RefusesWhatItIsNotGiven) {
    write_sides(1, 1.0);
    EXPECT_EQ(foverig({"compare", place("base")}).code, 2);
    EXPECT_EQ(foverig({"compare", place("base"), place("missing")}).code, 3);
    fs::create_directories(root_ / "empty");
    const Outcome empty = foverig({"compare", place("base"), place("empty")});
    EXPECT_EQ(empty.code, 3);
    EXPECT_THAT(empty.err, testing::MatchesRegex("foverig: [^\n]*is no run folder[^\n]+\n"));
    EXPECT_EQ(foverig({"compare", place("base"), place("new"), "--of", "beauty"}).code, 2);
    EXPECT_EQ(foverig({"compare", place("base"), place("new"), "--threshold", "nan"}).code, 2);
    const Outcome twice =
        foverig({"compare", place("base"), place("base/10"), "--against", place("new")});
    EXPECT_EQ(twice.code, 2) << "the same run is no other trial";
    EXPECT_THAT(twice.err, HasSubstr("base/10: is named twice"));
    std::ofstream(root_ / "new/10/summary.json") << "{\"schema\": \"foverig.summary/1\", ";
    EXPECT_EQ(foverig({"compare", place("base"), place("new")}).code, 3);
}

TEST_F(ProgramCompare, ComparesRunsAtFixedCostByteForByte) {
    ASSERT_EQ(small_run("a").code, 0);
    ASSERT_EQ(small_run("b").code, 0);
    const Outcome same = foverig({"compare", place("a"), place("b"), "--json"});
    EXPECT_EQ(same.code, 0) << same.err;
    EXPECT_THAT(same.out, HasSubstr("byte for byte"));
    EXPECT_THAT(same.out, HasSubstr("\"digest\""));

    std::ofstream(root_ / "b/images/frame_000003_left_final.png") << "not the same";
    const Outcome image = foverig({"compare", place("a"), place("b")});
    EXPECT_EQ(image.code, 6) << "different, not worse";
    EXPECT_THAT(image.out, HasSubstr("images/frame_000003_left_final.png: the pixels differ"));

    ASSERT_EQ(small_run("c", {"--set", "lighting.area_samples=3"}).code, 0);
    EXPECT_EQ(foverig({"compare", place("a"), place("c")}).code, 2);
    const Outcome rays =
        foverig({"compare", place("a"), place("c"), "--allow", "lighting.area_samples"});
    EXPECT_EQ(rays.code, 6);
    EXPECT_THAT(rays.out, HasSubstr("frames.csv: rays_shadow of frame 0 is "));

    ASSERT_EQ(small_run("d", {"--cost", "measured"}).code, 0);
    const Outcome mixed = foverig({"compare", place("a"), place("d"), "--allow", "cost"});
    EXPECT_EQ(mixed.code, 2);
    EXPECT_THAT(mixed.err, HasSubstr("some of the runs are at fixed cost"));
}

}  // namespace
}  // namespace foverig
