// The governor in a run, in lockstep: the dearest setting costs what the scenario says, the others
// in proportion, so that every decision repeats.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "rig/records/frames_csv.h"
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

/// Three settings; the dearest costs two VSyncs and a half at fixed:33.
const std::string kSettings =
    "governor.settings=4: foveation.p_min = 0.01; 7: foveation.p_min = 0.1; 20: foveation.p_min = "
    "1";

class ProgramGovernor : public test::ProgramBench {
  protected:
    Outcome run(const fs::path& out, const std::string& cost, std::vector<std::string> more) const {
        more.insert(more.end(), {"--cost", cost, "--frames", "400", "--set", "images.count=0",
                                 "--set", "images.frames=[]", "--set", "display.eye_width_px=32",
                                 "--set", "display.eye_height_px=32", "--set", "display.eyes=1",
                                 "--set", "display.distortion=false"});
        return small_run(out, more);
    }
    Json summary(const fs::path& out) const {
        return Json::parse(text_of(root_ / out / "summary.json"));
    }
};

TEST_F(ProgramGovernor, HoldsTheVsyncsThatTheScenarioAloneMisses) {
    ASSERT_EQ(run("alone", "fixed:33", {}).code, 0);
    const Outcome outcome = run("held", "fixed:33", {"--set", kSettings});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_GT(summary("alone")["vsync"]["missed_ratio"].get<double>(), 0.3);
    EXPECT_LT(summary("held")["vsync"]["missed_ratio"].get<double>(), 0.01);
    EXPECT_FALSE(summary("alone").contains("governor"));
    EXPECT_THAT(outcome.out, HasSubstr("governor          "));
}

TEST_F(ProgramGovernor, LeavesItsDecisionsInTheTimelineAndTheReport) {
    // 7 ms of 20 at fixed:33 are 11.55 ms: the middle setting fits the limit of 12.
    ASSERT_EQ(run("held", "fixed:33", {"--set", kSettings}).code, 0);
    const FrameTable frames = read_frames_csv(root_ / "held/frames.csv");
    const auto chosen = frames.column("governor_setting");
    ASSERT_EQ(chosen.size(), 400U);
    EXPECT_EQ(*chosen.back(), 1.0);
    const Json governor = summary("held")["governor"];
    std::vector<std::size_t> counted(3);
    for (const auto& setting : chosen) ++counted[static_cast<std::size_t>(*setting)];
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(governor["settings"][i]["frames"].get<std::size_t>(), counted[i]);
    EXPECT_NEAR(governor["limit_ms"].get<double>(), 0.9 * 1000.0 / 75.0, 1e-9);
    const std::string page = text_of(root_ / "held/report.html");
    EXPECT_THAT(page, HasSubstr("What the governor chose"));
    EXPECT_THAT(page, HasSubstr("foveation.p_min = 0.1"));
}

TEST_F(ProgramGovernor, RepeatsBitForBit) {
    ASSERT_EQ(run("a", "fixed:40", {"--set", kSettings}).code, 0);
    ASSERT_EQ(run("b", "fixed:40", {"--set", kSettings}).code, 0);
    EXPECT_TRUE(same_bytes(root_ / "a/frames.csv", root_ / "b/frames.csv"));
}

TEST_F(ProgramGovernor, SaysTheErrorItPaidWhereASweepHasMeasuredIt) {
    std::ofstream(root_ / "pareto.json") << R"({"schema": "foverig.pareto/1", "error": "acuity",
        "points": [{"settings": {"foveation.p_min": 0.01}}, {"settings": {"foveation.p_min": 1.0}}],
        "front": [{"point": 0, "time_ms": 5.0, "error": 0.02},
                  {"point": 1, "time_ms": 20.0, "error": 0.004}]})";
    const std::string front = "governor.front=" + (root_ / "pareto.json").string();
    const Outcome outcome = run("held", "fixed:33", {"--set", front});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Json governor = summary("held")["governor"];
    EXPECT_NEAR(governor["error_paid"].get<double>(), 0.02, 1e-3);
    EXPECT_EQ(governor["error_dearest"], 0.004);
    EXPECT_THAT(outcome.out, HasSubstr("acuity"));
}

}  // namespace
}  // namespace foverig
