// `foverig run --display window` as its users meet it.
#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "devices/display/eye_map.h"
#include "tests/rig/program_bench.h"
#include "tests/window/xvfb.h"
// Xlib last: its macros.
#include "tests/window/person.h"

namespace foverig {
namespace {

using test::Outcome;
using test::text_of;
using testing::HasSubstr;
namespace fs = std::filesystem;

class ProgramWindowTest : public test::ProgramBench {
  protected:
    Outcome windowed_run(std::vector<std::string> more) const {
        std::vector<std::string> arguments{"run",
                                           "--scene",
                                           "cornell",
                                           "--display",
                                           "window",
                                           "--out",
                                           (root_ / "run").string(),
                                           "--set",
                                           "display.eye_width_px=96",
                                           "--set",
                                           "display.eye_height_px=96",
                                           "--set",
                                           "settle_s=0.05",
                                           "--set",
                                           "scene_detail=0.2",
                                           "--set",
                                           "images.count=0",
                                           "--set",
                                           "window.width_px=640"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return test::foverig(arguments);
    }
    nlohmann::json summary() const {
        return nlohmann::json::parse(text_of(root_ / "run/summary.json"));
    }
};

TEST_F(ProgramWindowTest, ShowsARunAndSaysHowSureItsVsyncsAre) {
    const test::Xvfb desktop;
    ASSERT_TRUE(desktop.ready());
    const Outcome run = windowed_run({"--frames", "5"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("a window of 640x360: Escape ends the run"));
    const auto s = summary();
    EXPECT_EQ(s["frames"]["rendered"], 5);
    EXPECT_EQ(s["display"]["vsync_from"], "own clock");
    EXPECT_NEAR(s["display"]["vsync_error_ms"].get<double>(), 500.0 / 75.0, 1e-3);
    EXPECT_EQ(s["display"]["hud_frames"], 0);
    EXPECT_EQ(s["devices"]["panel"]["origin"], "window");
    EXPECT_THAT(text_of(root_ / "run/report.html"),
                HasSubstr("Shown in a window on an ordinary screen"));
    EXPECT_EQ(s["latency_ms"]["warp_to_photon"]["n"], s["latency_ms"]["motion_to_photon"]["n"]);
    EXPECT_LE(s["latency_ms"]["warp_to_photon"]["p50"].get<double>(),
              s["latency_ms"]["motion_to_photon"]["p50"].get<double>());
    EXPECT_TRUE(s["pass_time_ms"].contains("window_lens"));
    EXPECT_TRUE(s["pass_time_ms"].contains("window_upload"));
    EXPECT_FALSE(s["pass_time_ms"].contains("lens_distortion")) << "the window's work";
    EXPECT_EQ(s["scenario"]["clock"], "wall");
    EXPECT_FALSE(s["pass_time_ms"].contains("see_through")) << "off unless asked for";
    EXPECT_FALSE(s["devices"].contains("see_through"));
}

TEST_F(ProgramWindowTest, TheHudIsCountedWhereItIsOn) {
    const test::Xvfb desktop;
    ASSERT_TRUE(desktop.ready());
    const Outcome run = windowed_run(
        {"--frames", "4", "--set", "window.hud=true", "--set", "window.late_warp=false"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(summary()["display"]["hud_frames"], 4);
    EXPECT_TRUE(summary()["latency_ms"]["warp_to_photon"].is_null());
}

TEST_F(ProgramWindowTest, ACameraSeesThrough) {
    const test::Xvfb desktop;
    ASSERT_TRUE(desktop.ready());
    const Outcome run = windowed_run({"--frames", "75", "--set", "see_through.camera=sim",
                                      "--fail-if", "devices.see_through.lost > 0", "--fail-if",
                                      "latency_ms.see_through_to_photon.p50 > 1e6"});
    ASSERT_EQ(run.code, 0) << run.err;
    const auto s = summary();
    EXPECT_GE(s["devices"]["see_through"]["samples"].get<int>(), 20);
    EXPECT_EQ(s["devices"]["see_through"]["lost"], 0);
    // 35 ms from exposure to arrival, up to 33 ms until the next, and a frame.
    EXPECT_GE(s["latency_ms"]["see_through_to_photon"]["p50"].get<double>(), 35.0);
    EXPECT_TRUE(s["pass_time_ms"].contains("see_through"));
    EXPECT_EQ(s["devices"]["see_through"]["origin"], "simulated");
}

TEST_F(ProgramWindowTest, WhatItSawIsRecordedAndSeenAgain) {
    const test::Xvfb desktop;
    ASSERT_TRUE(desktop.ready());
    const Outcome run = windowed_run({"--frames", "75", "--set", "see_through.camera=sim", "--set",
                                      "see_through.distortion=[-0.25,0.05,0,0,0]", "--set",
                                      "recording.enabled=true"});
    ASSERT_EQ(run.code, 0) << run.err;
    const auto first = summary();
    const std::string recording = (root_ / "run/session.mcap").string();
    const auto replay = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments{"replay", recording, "--out",
                                           (root_ / "again").string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return test::foverig(arguments);
    };
    const Outcome again = replay({});
    ASSERT_EQ(again.code, 0) << again.err;
    const auto s = nlohmann::json::parse(text_of(root_ / "again/summary.json"));
    EXPECT_EQ(s["devices"]["see_through"]["origin"], "recorded");
    EXPECT_EQ(s["devices"]["see_through"]["recorded_from"], "simulated");
    EXPECT_GT(s["devices"]["see_through"]["samples"].get<int>(), 0);
    EXPECT_LE(s["devices"]["see_through"]["samples"].get<int>(),
              first["devices"]["see_through"]["samples"].get<int>());
    EXPECT_EQ(s["devices"]["see_through"]["lost"], 0);
    EXPECT_GE(s["latency_ms"]["see_through_to_photon"]["p50"].get<double>(), 35.0);
    EXPECT_EQ(s["scenario"]["see_through"]["distortion"][0], -0.25);

    const Outcome hidden = replay({"--display", "virtual"});
    EXPECT_EQ(hidden.code, 2);
    EXPECT_THAT(hidden.err, HasSubstr("--set see_through.camera="));
    fs::remove_all(root_ / "again");
    const Outcome without = replay({"--display", "virtual", "--set", "see_through.camera="});
    EXPECT_EQ(without.code, 0) << without.err;
}

TEST_F(ProgramWindowTest, TheCursorIsTheGaze) {
    const test::Xvfb desktop;
    ASSERT_TRUE(desktop.ready());
    test::Person().move_to(200, 135);  // left eye, a quarter right and a quarter up
    const Outcome run = windowed_run({"--gaze", "mouse", "--frames", "112"});
    ASSERT_EQ(run.code, 0) << run.err;
    const auto s = summary();
    EXPECT_EQ(s["scenario"]["motion"]["gaze"], "mouse");
    EXPECT_TRUE(s["latency_ms"]["gaze_error_deg"].is_null()) << "nobody knows a hand's next move";
    EXPECT_GT(s["devices"]["gaze"]["samples"], 0);

    std::istringstream csv(text_of(root_ / "run/frames.csv"));
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(csv, line);) {
        std::istringstream cells(line);
        auto& row = rows.emplace_back();
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    }
    const auto last = [&](const char* name) {
        const auto at = std::find(rows.front().begin(), rows.front().end(), name);
        return std::stod(rows.back()[static_cast<std::size_t>(at - rows.front().begin())]);
    };
    const dvec2 tangent = EyeMap(true).tangent(Eye::left, {2.0 * 200 / 320.0 - 1.0, 0.25});
    const dvec3 expected = glm::normalize(dvec3(tangent, -1.0));
    EXPECT_NEAR(last("gaze_left_x"), expected.x, 1e-3);
    EXPECT_NEAR(last("gaze_left_y"), expected.y, 1e-3);
    EXPECT_LT(last("gaze_right_x"), last("gaze_left_x")) << "the other eye meets it";
}

TEST_F(ProgramWindowTest, EscapeEndsTheRunAndKeepsItsResults) {
    const test::Xvfb desktop;
    ASSERT_TRUE(desktop.ready());
    std::atomic<bool> done = false;
    std::thread hand([&] {
        test::Person person;
        while (!done) {
            std::error_code gone;
            for (const auto& entry : fs::recursive_directory_iterator(root_, gone)) {
                const bool going =
                    entry.path().filename() == "session.mcap" && entry.file_size(gone) > 100'000;
                const auto window = person.window_titled("foverig: cornell");
                if (going && window) person.press(*window, XK_Escape);
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
    });
    const Outcome run = windowed_run({"--frames", "100000", "--set", "recording.enabled=true"});
    done = true;
    hand.join();
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(summary()["interrupted"], true);
    EXPECT_GT(summary()["frames"]["rendered"], 0);
    EXPECT_TRUE(fs::exists(root_ / "run/report.html"));
}

TEST_F(ProgramWindowTest, WithoutADesktopItExitsWithFourAndSaysWhatToDo) {
    (void)unsetenv("DISPLAY");
    for (const char* kind : {"window", "headset"}) {
        const Outcome run = test::foverig(
            {"run", "--display", kind, "--frames", "1", "--out", (root_ / "run").string()});
        EXPECT_EQ(run.code, 4);
        EXPECT_THAT(run.err, testing::MatchesRegex("foverig: [^\n]+\n")) << "one sentence";
        EXPECT_THAT(run.err, HasSubstr("DISPLAY"));
        EXPECT_THAT(run.err, HasSubstr("--display "));
        EXPECT_FALSE(fs::exists(root_ / "run"));
    }
}

TEST_F(ProgramWindowTest, AWindowNeedsRealTimeAndAMouseNeedsAWindow) {
    const Outcome lockstep = test::foverig({"run", "--display", "window", "--clock", "lockstep"});
    EXPECT_EQ(lockstep.code, 2);
    EXPECT_THAT(lockstep.err, HasSubstr("--clock wall"));
    const Outcome blind = small_run("run", {"--gaze", "mouse"});
    EXPECT_EQ(blind.code, 2);
    EXPECT_THAT(blind.err, HasSubstr("--display window"));
}

}  // namespace
}  // namespace foverig
