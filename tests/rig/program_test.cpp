// The program as its users meet it: exit codes, messages, explanations.
#include "rig/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <functional>
#include <nlohmann/json.hpp>
#include <regex>
#include <thread>

#include "tests/rig/program_bench.h"

namespace foverig {
namespace {

using test::foverig;
using test::Outcome;
using test::text_of;
using testing::HasSubstr;
namespace fs = std::filesystem;

class ProgramTest : public test::ProgramBench {};

TEST_F(ProgramTest, ExitsWithOneWhereACheckFails) {
    const Outcome run =
        small_run("run", {"--fail-if", "frames.rendered == 4", "--fail-if", "vsync.missed > 1000"});
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.err, HasSubstr("check failed: frames.rendered == 4"));
    EXPECT_TRUE(fs::exists(root_ / "run/summary.json"));
}

TEST_F(ProgramTest, RefusesACheckOfAnUnknownKeyBeforeItRuns) {
    const Outcome run = small_run("run", {"--fail-if", "vsync.mised_ratio > 0.01"});
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err,
                HasSubstr("no number vsync.mised_ratio; the nearest is vsync.missed_ratio"));
    EXPECT_THAT(run.err, testing::Not(HasSubstr("loading")));
    EXPECT_FALSE(fs::exists(root_ / "run"));
    EXPECT_EQ(small_run("pass", {"--fail-if", "pass_time_ms.trace_primary.p98 > 1"}).code, 2);
    EXPECT_FALSE(fs::exists(root_ / "pass"));
}

TEST_F(ProgramTest, TakesChecksOfEveryNumberThatARunCanHave) {
    const std::string camera = "tracking.camera=true";
    ASSERT_EQ(small_run("run", {"--set", camera}).code, 0);
    const auto numbers = nlohmann::json::parse(text_of(root_ / "run/summary.json")).flatten();
    std::vector<std::string> checks{"--set", camera};
    for (const auto& [path, value] : numbers.items()) {
        std::string key = path.substr(1);
        std::replace(key.begin(), key.end(), '/', '.');
        const bool in_list = std::regex_search(key, std::regex("\\.[0-9]+(\\.|$)"));
        if (!value.is_number() || in_list) continue;
        checks.insert(checks.end(), {"--fail-if", key + " < -1e300"});
    }
    EXPECT_GT(checks.size(), 200U);
    const Outcome checked = small_run("checked", checks);
    EXPECT_EQ(checked.code, 0) << checked.err;
}

TEST_F(ProgramTest, ExitsWithTwoOnWrongUsage) {
    EXPECT_EQ(foverig({"fly"}).code, 2);
    EXPECT_EQ(foverig({"run", "--no-such-option"}).code, 2);
    EXPECT_EQ(foverig({"run", "--set", "frames=many"}).code, 2);
    EXPECT_THAT(foverig({"run", "--set", "reprojection.footprint_samples=3"}).err,
                HasSubstr("expected 1, 2, 4 or 8"));
    EXPECT_EQ(foverig({"run", "--devices", "wishful"}).code, 2);
    EXPECT_EQ(foverig({"run", "--display", "wishful"}).code, 2);
    EXPECT_EQ(foverig({"run", "--pipeline", "magic"}).code, 2);
    EXPECT_EQ(foverig({"run", "--fail-if", "nonsense"}).code, 2);
    EXPECT_EQ(foverig({"run", "--scene", "cornel"}).code, 2);
    EXPECT_EQ(foverig({"run", (root_ / "missing.toml").string()}).code, 2);
    EXPECT_THAT(foverig({"run", "--scene", "cornel"}).err, HasSubstr("cornell"));
    EXPECT_TRUE(fs::is_empty(root_));
}

TEST_F(ProgramTest, ExitsWithThreeOnASceneThatCannotBeUsed) {
    const fs::path broken = root_ / "broken.obj";
    std::ofstream(broken) << "this is no mesh\n";
    const Outcome run = small_run("run", {"--scene", broken.string()});
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr("broken.obj"));
    EXPECT_FALSE(fs::exists(root_ / "run"));
    EXPECT_EQ(small_run("run", {"--scene", (root_ / "missing.glb").string()}).code, 3);
    EXPECT_EQ(small_run("run", {"--set", "motion.head=" + (root_ / "no.csv").string()}).code, 3);
}

TEST_F(ProgramTest, ExitsWithFourOnADeviceThatIsNotThere) {
    // tests/window has the same of displays.
    const Outcome run = small_run("run", {"--devices", "hardware"});
    EXPECT_EQ(run.code, 4);
    EXPECT_THAT(run.err, testing::MatchesRegex("foverig: [^\n]+\n")) << "one sentence";
    EXPECT_THAT(run.err, HasSubstr("hardware"));
    EXPECT_FALSE(fs::exists(root_ / "run"));
    EXPECT_EQ(foverig({"plan", "--devices", "hardware"}).code, 4);
    EXPECT_EQ(foverig({"plan", "--scene", "cornell", "--devices", "hardware", "--no-run"}).code, 0);
}

/// Ctrl-C once the program listens (before, it must not be hit) and `ready`.
class Impatient {
  public:
    explicit Impatient(std::function<bool()> ready)
        : thread_([this, ready = std::move(ready)] {
              while (!done_) {
                  struct sigaction now {};
                  sigaction(SIGINT, nullptr, &now);
                  if (now.sa_handler != SIG_DFL && ready()) {
                      std::raise(SIGINT);
                      return;
                  }
                  std::this_thread::sleep_for(std::chrono::milliseconds(1));
              }
          }) {}
    ~Impatient() {
        done_ = true;
        thread_.join();
    }

  private:
    std::atomic<bool> done_ = false;
    std::thread thread_;
};

TEST_F(ProgramTest, EndsCleanlyOnCtrlC) {
    const auto frames_were_recorded = [&] {
        std::error_code gone;
        for (const auto& entry : fs::recursive_directory_iterator(root_, gone))
            if (entry.path().filename() == "session.mcap" && entry.file_size(gone) > 100'000)
                return true;
        return false;
    };
    const Impatient impatient(frames_were_recorded);
    const Outcome run = small_run("run", {"--frames", "100000", "--set", "images.frames=[]",
                                          "--set", "recording.enabled=true"});
    EXPECT_EQ(run.code, 0) << run.err;
    const auto s = nlohmann::json::parse(text_of(root_ / "run/summary.json"));
    EXPECT_EQ(s["interrupted"], true);
    EXPECT_GT(s["frames"]["rendered"], 0);
    EXPECT_LT(s["frames"]["rendered"], 100000);
}

TEST_F(ProgramTest, LeavesNothingBehindWhenInterruptedWhileLoading) {
    const Impatient impatient([] { return true; });
    const Outcome run = small_run("run", {"--scene", "city", "--frames", "100000"});
    if (run.code == 0) GTEST_SKIP() << "the scene was loaded before Ctrl-C came";
    EXPECT_EQ(run.code, 130) << run.err;
    EXPECT_THAT(run.err, HasSubstr("interrupted while loading"));
    EXPECT_TRUE(fs::is_empty(root_));
}

TEST_F(ProgramTest, ExplainsItself) {
    for (const char* command : {"run", "plan", "scenes", "devices", "report", "doctor"}) {
        const Outcome help = foverig({command, "--help"});
        EXPECT_EQ(help.code, 0) << command;
        EXPECT_THAT(help.out, HasSubstr(command));
    }
    EXPECT_THAT(foverig({"run", "--help"}).out, HasSubstr("--fail-if"));
    EXPECT_THAT(foverig({"run", "--help-scenario"}).out, HasSubstr("foveation.r0_deg = 10.0"));
    EXPECT_THAT(foverig({"--version"}).out, HasSubstr("foverig "));
    EXPECT_THAT(foverig({"scenes"}).out, HasSubstr("voxel-town"));
    EXPECT_THAT(foverig({"devices"}).out, HasSubstr("dk2.dropout"));
}

TEST_F(ProgramTest, PlansWithReasonsAndCosts) {
    const Outcome plan =
        foverig({"plan", "--scene", "cornell", "--set", "display.eye_width_px=64", "--set",
                 "display.eye_height_px=64", "--set", "settle_s=0", "--json"});
    ASSERT_EQ(plan.code, 0) << plan.err;
    bool measured = false;
    for (const auto& effect : nlohmann::json::parse(plan.out)) {
        EXPECT_FALSE(effect["because"].get<std::string>().empty());
        measured = measured || effect["measured_ms"].is_number();
        EXPECT_TRUE(effect["bytes"].is_number()) << effect["effect"];
    }
    EXPECT_TRUE(measured);
    EXPECT_THAT(
        foverig({"plan", "--scene", "tunnel-maps", "--no-run", "--set", "lighting.area_samples=0"})
            .out,
        HasSubstr("lighting.area_samples is 0"));
    for (const auto& effect :
         nlohmann::json::parse(foverig({"plan", "--scene", "cornell", "--no-run", "--json"}).out)) {
        EXPECT_EQ(effect["bytes"].is_null(), effect["on"].get<bool>()) << "on, but never run";
    }
}

// Every scenario that is shipped must at least be understood.
TEST(ShippedScenarios, AreValid) {
    for (const auto& entry : fs::directory_iterator(FOVERIG_SOURCE_DIR "/docs/scenarios")) {
        const Outcome plan =
            foverig({"plan", entry.path().string(), "--no-run", "--scene", "cornell"});
        EXPECT_EQ(plan.code, 0) << entry.path() << plan.err;
    }
}

}  // namespace
}  // namespace foverig
