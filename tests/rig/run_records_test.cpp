// What a run leaves in its folder, and what can be made of it again.
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
namespace fs = std::filesystem;

class RunRecords : public test::ProgramBench {};

TEST_F(RunRecords, WritesAWholeRunFolder) {
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
TEST_F(RunRecords, KeepsThePromiseOfTheSummary) {
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
                            "/devices/panel/samples",
                            "/devices/panel/rate_hz",
                            "/memory/backend_bytes",
                            "/memory/base_bytes",
                            "/memory/peak_rss_bytes",
                            "/numerics/nan",
                            "/numerics/inf",
                            "/numerics/clamped"}) {
        EXPECT_TRUE(has(key)) << key;
    }
    EXPECT_TRUE(s["host"]["gpu"].is_null());
    EXPECT_EQ(s["frames"]["rendered"], 4);
}

TEST_F(RunRecords, EstimateTimesWhereTheyWereMeasured) {
    ASSERT_EQ(small_run("fixed").code, 0);
    const Outcome measured = small_run("measured", {"--cost", "measured", "--frames", "12"});
    ASSERT_EQ(measured.code, 0);
    const auto steady = [&](const char* run) {
        return nlohmann::json::parse(text_of(root_ / run / "summary.json"))["steady_frame_time_ms"];
    };
    EXPECT_TRUE(steady("fixed").is_null());
    const auto summary = [&](const char* run) {
        return nlohmann::json::parse(text_of(root_ / run / "summary.json"));
    };
    for (const char* key : {"cpu_time_ms", "processor_use"}) {
        EXPECT_TRUE(summary("fixed")[key].is_null()) << key;
        EXPECT_TRUE(summary("measured")[key].is_object()) << key;
    }
    EXPECT_GT(summary("measured")["cpu_time_ms"]["min"], 0.0);
    EXPECT_GT(summary("measured")["processor_use"]["own"], 0.0);
    EXPECT_EQ(steady("measured")["n"], 12);
    EXPECT_TRUE(steady("measured")["p99"]["value"].is_null());
    EXPECT_NE(measured.out.find("p99 n too small"), std::string::npos) << measured.out;
}

TEST_F(RunRecords, AccountForAllMemoryOfTheBackend) {
    ASSERT_EQ(small_run("run").code, 0);
    const auto s = nlohmann::json::parse(text_of(root_ / "run/summary.json"));
    std::uint64_t bytes = s["memory"]["base_bytes"].get<std::uint64_t>();
    EXPECT_GT(bytes, 0U);
    for (const auto& effect : s["plan"]) {
        EXPECT_TRUE(effect["on"].get<bool>() || effect["bytes"] == 0) << effect["effect"];
        EXPECT_TRUE(effect["effect"] != "reprojection" || effect["bytes"] > 0);
        bytes += effect["bytes"].get<std::uint64_t>();
    }
    EXPECT_EQ(s["memory"]["backend_bytes"], bytes);
}

TEST_F(RunRecords, ListThePanelAmongTheDevices) {
    ASSERT_EQ(small_run("run", {"--frames", "12"}).code, 0);
    const auto panel =
        nlohmann::json::parse(text_of(root_ / "run/summary.json"))["devices"]["panel"];
    EXPECT_GT(panel["samples"], 6) << "most corner pixels are read back";
    EXPECT_LE(panel["samples"], 12);
    EXPECT_NEAR(panel["rate_hz"].get<double>(), 75.0, 0.01);
    for (const char* key : {"lost", "rejected", "reconnects", "outages"})
        EXPECT_TRUE(panel[key].is_null()) << key << ": a panel sends nothing of its own";
}

TEST_F(RunRecords, SayWhatWasSimulated) {
    ASSERT_EQ(small_run("run", {"--set", "recording.enabled=true"}).code, 0);
    const fs::path recording = root_ / "run/session.mcap";
    ASSERT_EQ(small_run("again", {"--devices", "replay:" + recording.string()}).code, 0);
    for (const auto& [name, origin, words] :
         {std::tuple("run", "simulated", "Simulated: headset (the head moves as look)"),
          std::tuple("again", "recorded",
                     "Recorded: headset (a simulated one), gaze tracker (a simulated one).")}) {
        const auto devices =
            nlohmann::json::parse(text_of(root_ / name / "summary.json"))["devices"];
        EXPECT_EQ(devices["dk2"]["origin"], origin);
        EXPECT_EQ(devices["gaze"]["origin"], origin);
        EXPECT_EQ(devices["panel"]["origin"], "simulated");
        EXPECT_THAT(text_of(root_ / name / "report.html"), HasSubstr(words));
        ASSERT_EQ(foverig({"report", (root_ / name).string(), "--export", "markdown"}).code, 0);
        EXPECT_THAT(text_of(root_ / name / "summary.md"), HasSubstr(words));
    }
}

TEST_F(RunRecords, TellOfADeviceThatWasUnplugged) {
    const Outcome run =
        small_run("run", {"--frames", "40", "--set", "settle_s=0.1", "--set",
                          "faults.dk2.unplug_at=0.3", "--set", "faults.dk2.unplug_for=0.1"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.err.find("dk2 is lost at 0.3"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("dk2 is back at 0.40 s"), std::string::npos) << run.err;
    EXPECT_NE(run.out.find("lost              dk2: at 0.3"), std::string::npos) << run.out;
    const auto dk2 = nlohmann::json::parse(text_of(root_ / "run/summary.json"))["devices"]["dk2"];
    ASSERT_EQ(dk2["outages"].size(), 1U);
    EXPECT_NEAR(dk2["outages"][0]["lost_s"].get<double>(), 0.3, 0.02);
    EXPECT_NEAR(dk2["outages"][0]["back_s"].get<double>(), 0.4, 0.002);
}

TEST_F(RunRecords, RunsAgainFromItsOwnScenario) {
    ASSERT_EQ(small_run("a").code, 0);
    const Outcome again =
        foverig({"run", (root_ / "a/scenario.toml").string(), "--out", (root_ / "b").string()});
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(text_of(root_ / "a/scenario.toml"), text_of(root_ / "b/scenario.toml"));
    EXPECT_TRUE(same_bytes(root_ / "a/frames.csv", root_ / "b/frames.csv"));
}

TEST_F(RunRecords, MakesTheReportAgainFromTheRecords) {
    ASSERT_EQ(small_run("run").code, 0);
    const std::string first = text_of(root_ / "run/report.html");
    fs::remove(root_ / "run/report.html");
    EXPECT_EQ(foverig({"report", (root_ / "run").string()}).code, 0);
    EXPECT_TRUE(text_of(root_ / "run/report.html") == first);
    EXPECT_EQ(foverig({"report", root_.string()}).code, 3);
    const auto nowhere = (root_ / "none/all.json").string();
    const Outcome together = foverig({"report", (root_ / "run").string(), "--together", nowhere});
    EXPECT_EQ(together.code, 2);
    EXPECT_THAT(together.err, HasSubstr("--together " + nowhere + ": cannot be written"));
}

}  // namespace
}  // namespace foverig
