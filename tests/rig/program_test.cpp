// The program as its users meet it: exit codes, messages, run folders. In process, on small images.
#include "rig/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

namespace foverig {
namespace fs = std::filesystem;
namespace {

using testing::HasSubstr;

struct Outcome {
    int code = 0;
    std::string out;
    std::string err;
};

Outcome foverig(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "foverig");
    std::vector<const char*> argv;
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = run_program(static_cast<int>(argv.size()), argv.data());
    std::fflush(stdout);
    Outcome outcome{code, testing::internal::GetCapturedStdout(),
                    testing::internal::GetCapturedStderr()};
    return outcome;
}

std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// Without showing the bytes where they differ: images would flood the screen.
bool same_bytes(const fs::path& a, const fs::path& b) {
    return text_of(a) == text_of(b);
}

class ProgramTest : public testing::Test {
  protected:
    void SetUp() override {
        root_ = fs::path(testing::TempDir()) / ("program_test_" + std::to_string(getpid()));
        fs::remove_all(root_);
        fs::create_directories(root_);
    }
    void TearDown() override { fs::remove_all(root_); }

    /// A run that takes a moment: a small Cornell box at a fixed cost.
    Outcome small_run(const fs::path& out, std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments{"run",
                                           "--scene",
                                           "cornell",
                                           "--frames",
                                           "4",
                                           "--cost",
                                           "fixed:10",
                                           "--out",
                                           (root_ / out).string(),
                                           "--set",
                                           "display.eye_width_px=96",
                                           "--set",
                                           "display.eye_height_px=96",
                                           "--set",
                                           "settle_s=0.05",
                                           "--set",
                                           "scene_detail=0.2",
                                           "--set",
                                           "images.frames=[3]"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return foverig(arguments);
    }

    fs::path root_;
};

TEST_F(ProgramTest, WritesAWholeRunFolder) {
    const Outcome run = small_run("run", {"--json"});
    ASSERT_EQ(run.code, 0) << run.err;
    for (const char* file :
         {"summary.json", "frames.csv", "plan.json", "scenario.toml", "report.html",
          "images/frame_000003_left_final.png", "images/frame_000003_right_sampling.png",
          "images/frame_000003_left_error.png", "images/frame_000003_panel.png"}) {
        EXPECT_TRUE(fs::exists(root_ / "run" / file)) << file;
    }
    EXPECT_THAT(run.out, HasSubstr("report: "));
    const auto start = run.out.rfind('\n', run.out.size() - 2) + 1;
    const auto last = nlohmann::json::parse(run.out.substr(start));
    EXPECT_EQ(last, nlohmann::json::parse(text_of(root_ / "run/summary.json")));
}

// The keys that DESIGN promises: add, never rename.
TEST_F(ProgramTest, KeepsThePromiseOfTheSummary) {
    ASSERT_EQ(small_run("run").code, 0);
    const auto s = nlohmann::json::parse(text_of(root_ / "run/summary.json"));
    EXPECT_EQ(s["schema"], "foverig.summary/1");
    const auto has = [&](const char* pointer) {
        return s.contains(nlohmann::json::json_pointer(pointer));
    };
    for (const char* key : {"/build/version",
                            "/build/git",
                            "/build/compiler",
                            "/build/flags",
                            "/build/backend",
                            "/build/device",
                            "/host/cpu",
                            "/host/cores",
                            "/host/gpu",
                            "/host/os",
                            "/scenario/scene",
                            "/scenario/foveation/r0_deg",
                            "/plan/0/effect",
                            "/plan/0/on",
                            "/plan/0/because",
                            "/plan/0/passes",
                            "/plan/0/bytes",
                            "/frames/rendered",
                            "/frames/presented",
                            "/frames/dropped",
                            "/frame_time_ms/n",
                            "/frame_time_ms/mean",
                            "/frame_time_ms/min",
                            "/frame_time_ms/p50",
                            "/frame_time_ms/p90",
                            "/frame_time_ms/p99",
                            "/frame_time_ms/max",
                            "/frame_time_ms/p50_ci95",
                            "/pass_time_ms",
                            "/rays/primary",
                            "/rays/shadow",
                            "/rays/ao",
                            "/rays/reflection",
                            "/rays/probe",
                            "/rays/vpl",
                            "/rays/total",
                            "/sampled_pixel_ratio",
                            "/vsync/rate_hz",
                            "/vsync/budget_ms",
                            "/vsync/missed",
                            "/vsync/missed_ratio",
                            "/vsync/utilisation",
                            "/latency_ms/motion_to_photon",
                            "/latency_ms/gaze_to_photon",
                            "/latency_ms/imu_transport",
                            "/latency_ms/gaze_transport",
                            "/latency_ms/motion_to_photon_readback",
                            "/latency_ms/prediction_error_deg",
                            "/devices/dk2/samples",
                            "/devices/dk2/lost",
                            "/devices/dk2/rejected",
                            "/devices/dk2/reconnects",
                            "/devices/gaze/rate_hz",
                            "/memory/backend_bytes",
                            "/memory/peak_rss_bytes",
                            "/numerics/nan",
                            "/numerics/inf",
                            "/numerics/clamped"}) {
        EXPECT_TRUE(has(key)) << key;
    }
    EXPECT_TRUE(s["host"]["gpu"].is_null());
    EXPECT_EQ(s["frames"]["rendered"], 4);
}

TEST_F(ProgramTest, RepeatsByteForByteAtFixedCost) {
    ASSERT_EQ(small_run("a").code, 0);
    ASSERT_EQ(small_run("b", {"--set", "threads=1"}).code, 0);
    EXPECT_TRUE(same_bytes(root_ / "a/frames.csv", root_ / "b/frames.csv"));
    for (const auto& image : fs::directory_iterator(root_ / "a/images")) {
        EXPECT_TRUE(same_bytes(image.path(), root_ / "b/images" / image.path().filename()))
            << image.path();
    }
}

TEST_F(ProgramTest, RunsAgainFromItsOwnScenario) {
    ASSERT_EQ(small_run("a").code, 0);
    const Outcome again =
        foverig({"run", (root_ / "a/scenario.toml").string(), "--out", (root_ / "b").string()});
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(text_of(root_ / "a/scenario.toml"), text_of(root_ / "b/scenario.toml"));
    EXPECT_TRUE(same_bytes(root_ / "a/frames.csv", root_ / "b/frames.csv"));
}

TEST_F(ProgramTest, MakesTheReportAgainFromTheRecords) {
    ASSERT_EQ(small_run("run").code, 0);
    const std::string first = text_of(root_ / "run/report.html");
    fs::remove(root_ / "run/report.html");
    EXPECT_EQ(foverig({"report", (root_ / "run").string()}).code, 0);
    EXPECT_TRUE(text_of(root_ / "run/report.html") == first);
    EXPECT_EQ(foverig({"report", root_.string()}).code, 3);
}

TEST_F(ProgramTest, ExitsWithOneWhereACheckFails) {
    const Outcome run =
        small_run("run", {"--fail-if", "frames.rendered == 4", "--fail-if", "vsync.missed > 1000"});
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.err, HasSubstr("check failed: frames.rendered == 4"));
    EXPECT_TRUE(fs::exists(root_ / "run/summary.json"));
}

TEST_F(ProgramTest, ExitsWithTwoOnWrongUsage) {
    EXPECT_EQ(foverig({"fly"}).code, 2);
    EXPECT_EQ(foverig({"run", "--no-such-option"}).code, 2);
    EXPECT_EQ(foverig({"run", "--set", "frames=many"}).code, 2);
    EXPECT_EQ(foverig({"run", "--devices", "hardware"}).code, 2);
    EXPECT_EQ(foverig({"run", "--display", "headset"}).code, 2);
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

TEST_F(ProgramTest, EndsCleanlyOnCtrlC) {
    std::atomic<bool> done = false;
    // Ctrl-C again and again until the program has heard it; before it listens, it must not be hit.
    std::thread impatient([&] {
        while (!done && !fs::exists(root_)) std::this_thread::yield();
        while (!done) {
            struct sigaction now {};
            sigaction(SIGINT, nullptr, &now);
            if (now.sa_handler != SIG_DFL) {
                std::raise(SIGINT);
                return;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    });
    const Outcome run = small_run("run", {"--frames", "100000", "--set", "images.frames=[]"});
    done = true;
    impatient.join();
    EXPECT_EQ(run.code, 0) << run.err;
    const auto s = nlohmann::json::parse(text_of(root_ / "run/summary.json"));
    EXPECT_EQ(s["interrupted"], true);
    EXPECT_LT(s["frames"]["rendered"], 100000);
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
    }
    EXPECT_TRUE(measured);
    EXPECT_THAT(
        foverig({"plan", "--scene", "tunnel-maps", "--no-run", "--set", "lighting.area_samples=0"})
            .out,
        HasSubstr("lighting.area_samples is 0"));
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
