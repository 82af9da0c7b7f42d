#include "rig/session/session.h"

#include <gtest/gtest.h>

#include "rig/records/columns.h"
#include "rig/records/frames_csv.h"
#include "rig/records/vsync_count.h"
#include "simulators/panel/virtual_panel.h"
#include "tests/rig/session/small_session.h"

namespace foverig {
namespace {
using test::kPeriod_ms;
using test::run;
using test::scenario_of;
using test::small_scene;

TEST(Session, RepeatsBitForBitAtFixedCost) {
    Scenario s = scenario_of(7.3, 60);
    s.motion.head = "look";
    s.motion.gaze = "scan";
    s.faults.dk2.noise = 1.0;
    s.faults.gaze.dropout = 0.1;
    s.faults.panel.vsync_jitter = 50.0;
    const std::string first = frames_csv(run(s).frames, WallTimes::omit);
    EXPECT_EQ(frames_csv(run(s).frames, WallTimes::omit), first);
    s.render.seed = 2;
    EXPECT_NE(frames_csv(run(s).frames, WallTimes::omit), first);
}

TEST(Session, ShowsAFrameAtEachVsyncWithinBudget) {
    const RunRecord r = run(scenario_of(10.0, 40));
    const VsyncCount c = count_vsyncs(r.frames);
    EXPECT_EQ(c.presented, 40U);
    EXPECT_EQ(c.total, 40U);
    EXPECT_EQ(c.missed, 0U);
    EXPECT_EQ(c.late, 0U);
    for (const FrameRecord& f : r.frames) {
        EXPECT_EQ(to_ms(f.present - f.begin), 10.0);
        EXPECT_EQ(f.aimed_vsync, *f.vsync);
    }
}

TEST(Session, RepeatsOldFramesWhereTheBudgetIsBroken) {
    // 30 ms take three periods of 13.3 ms: of each three VSyncs one has a new frame.
    const VsyncCount c = count_vsyncs(run(scenario_of(30.0, 20)).frames);
    EXPECT_EQ(c.presented, 20U);
    EXPECT_EQ(c.total, 1U + 19U * 3U);
    EXPECT_EQ(c.missed, 19U * 2U);
    EXPECT_EQ(c.late, 20U);
    EXPECT_EQ(c.dropped, 0U);
}

TEST(Session, CountsMissesPerFrame) {
    const RunRecord r = run(scenario_of(30.0, 5));
    EXPECT_EQ(r.frames[0].missed_vsyncs, 0U);
    for (std::size_t i = 1; i < r.frames.size(); ++i) EXPECT_EQ(r.frames[i].missed_vsyncs, 2U);
}

TEST(Session, DropsFramesThatAreReplacedBeforeTheirVsync) {
    Scenario s = scenario_of(5.0, 60);
    s.display.pacing = "free";
    const RunRecord r = run(s);
    const VsyncCount c = count_vsyncs(r.frames);
    EXPECT_EQ(c.rendered, 60U);
    EXPECT_EQ(c.rendered, c.presented + c.dropped);
    EXPECT_EQ(c.total, c.presented + c.missed);
    EXPECT_EQ(c.missed, 0U);
    // 60 frames of 5 ms are 300 ms: 22 or 23 VSyncs.
    EXPECT_NEAR(static_cast<double>(c.presented), 300.0 / kPeriod_ms, 1.0);
    for (const FrameRecord& f : r.frames) EXPECT_EQ(f.dropped(), !f.photon.has_value());
}

TEST(Session, BeginsOneFrameAtEachVsyncEvenAtNoCost) {
    const VsyncCount c = count_vsyncs(run(scenario_of(0.0, 10)).frames);
    EXPECT_EQ(c.presented, 10U);
    EXPECT_EQ(c.dropped, 0U);
}

// DEVICES.md 2.3: 27.3 us to the first row, 1920 rows of 1933, right to left, 100 us settle and
// half of 435 rows of persistence, at 75 Hz.
TEST(Session, PutsPhotonsWhereThePanelScans) {
    const RunRecord r = run(scenario_of(10.0, 3));
    const double row_ms = kPeriod_ms / 1933.0;
    const double before_ms = 0.0273 + 0.1 + 0.5 * 435.0 * row_ms;
    for (const FrameRecord& f : r.frames) {
        EXPECT_NEAR(to_ms(*f.photon_eye[1] - *f.vsync), before_ms + 0.25 * 1920.0 * row_ms, 1e-5);
        EXPECT_NEAR(to_ms(*f.photon_eye[0] - *f.vsync), before_ms + 0.75 * 1920.0 * row_ms, 1e-5);
        EXPECT_NEAR(to_ms(*f.photon - *f.vsync), before_ms + 0.5 * 1920.0 * row_ms, 1e-5);
    }
}

TEST(Session, AddsLatencyUpFromItsLinks) {
    const RunRecord r = run(scenario_of(10.0, 30));
    for (const FrameRecord& f : r.frames) {
        ASSERT_TRUE(f.pose && f.gaze);
        const double links_ms = to_ms(f.pose->arrived - f.pose->taken) +
                                to_ms(f.begin - f.pose->arrived) + to_ms(f.submit - f.begin) +
                                to_ms(f.present - f.submit) + to_ms(*f.vsync - f.present) +
                                to_ms(*f.photon - *f.vsync);
        EXPECT_NEAR(*motion_to_photon_ms(f), links_ms, 1e-9);
        EXPECT_LE(f.pose->arrived, f.begin);
        EXPECT_LE(f.gaze->arrived, f.begin);
        // A 1 kHz sensor's newest sample is at most its period and its way old.
        EXPECT_LT(to_ms(f.begin - f.pose->taken), 3.0);
        // 60 Hz: at most a period, 12 ms in the tracker and 1 ms on USB.
        EXPECT_LT(to_ms(f.begin - f.gaze->taken), 1000.0 / 60.0 + 13.5);
        EXPECT_GE(to_ms(f.begin - f.gaze->taken), 12.0);
    }
}

TEST(Session, PredictsTheLightOfTheFrame) {
    const RunRecord r = run(scenario_of(30.0, 20));
    // From the second frame on the cost is known, so the VSync is foreseen.
    for (std::size_t i = 1; i < r.frames.size(); ++i) {
        EXPECT_EQ(r.frames[i].predicted_photon, *r.frames[i].photon);
    }
}

TEST(Session, SeesNoErrorWhereNothingMoves) {
    for (const FrameRecord& f : run(scenario_of(10.0, 20)).frames) {
        EXPECT_LT(*f.prediction_error_deg, 0.05);
        EXPECT_LT(*f.gaze_error_deg, 0.05);
    }
}

TEST(Session, FollowsAMovingHead) {
    Scenario s = scenario_of(10.0, 100);
    s.motion.head = "stress";
    double most_deg = 0.0;
    double turned_deg = 0.0;
    for (const FrameRecord& f : run(s).frames) {
        most_deg = std::max(most_deg, *f.prediction_error_deg);
        turned_deg = std::max(turned_deg, glm::degrees(glm::angle(f.world_from_head)));
    }
    EXPECT_GT(turned_deg, 4.0);  // swings by 5.5 degrees
    EXPECT_LT(most_deg, 2.0);    // unpredicted, 173 deg/s over 22 ms would be 3.8
}

TEST(Session, GivesTheRendererTwoEyesOfADk2) {
    FakeRenderer renderer;
    run(scenario_of(10.0, 2), renderer);
    const FrameInput& input = renderer.inputs.back();
    ASSERT_EQ(input.eyes.size(), 2U);
    const EyeView& left = input.eyes[0].view;
    const EyeView& right = input.eyes[1].view;
    // DEVICES.md 2.2
    EXPECT_EQ(left.width_px, 1182);
    EXPECT_EQ(left.height_px, 1464);
    EXPECT_NEAR(left.tan_left, 1.058657, 1e-5);
    EXPECT_NEAR(left.tan_right, 1.092368, 1e-5);
    EXPECT_NEAR(right.tan_left, left.tan_right, 1e-6);
    EXPECT_NEAR(left.tan_up, 1.331603, 1e-5);
    EXPECT_NEAR(glm::length(right.position_m - left.position_m), 0.064, 1e-4);
    // The head rests, so the eyes are where the path's only key is, looking at its target.
    EXPECT_NEAR(glm::length(0.5F * (left.position_m + right.position_m) - vec3(0.0F, 1.6F, 4.0F)),
                0.0, 2e-3);
    EXPECT_NEAR(glm::dot(left.world_from_eye * vec3(0, 0, -1), vec3(0, 0, -1)), 1.0, 1e-4);
}

TEST(Session, GivesTheRendererOneEyeWhereOneIsAskedFor) {
    Scenario s = scenario_of(10.0, 2);
    s.display.eyes = 1;
    FakeRenderer renderer;
    const RunRecord r = run(s, renderer);
    EXPECT_EQ(renderer.inputs.back().eyes.size(), 1U);
    EXPECT_FALSE(r.frames[0].photon_eye[1].has_value());
    EXPECT_EQ(r.frames[0].photon, r.frames[0].photon_eye[0]);
}

TEST(Session, EndsWhenAskedTo) {
    FakeRenderer renderer;
    SessionHooks hooks;
    int asked = 0;
    hooks.stop_requested = [&] { return ++asked > 3; };
    const RunRecord r = run(scenario_of(10.0, 100), renderer, hooks);
    EXPECT_TRUE(r.interrupted);
    EXPECT_EQ(r.frames.size(), 3U);
}

TEST(Session, EndsAfterItsSeconds) {
    Scenario s = scenario_of(10.0, 0);
    s.seconds = 0.5;
    const RunRecord r = run(s);
    EXPECT_NEAR(static_cast<double>(r.frames.size()), 0.5 * 75.0, 1.0);
}

TEST(Session, GoesOnWhileAHeadsetIsUnplugged) {
    Scenario s = scenario_of(10.0, 80);
    s.faults.dk2.unplug_at = 0.7;
    s.faults.dk2.unplug_for = 0.2;
    const RunRecord r = run(s);
    EXPECT_EQ(r.frames.size(), 80U);
    ASSERT_EQ(r.devices[0].name, "dk2");
    EXPECT_GT(r.devices[0].counts.reconnects, 0U);
    // Stale from 0.1 s after the last sample until it is back: about 0.1 s of the 0.2 s, at 75 Hz.
    const auto stale = std::count_if(r.frames.begin(), r.frames.end(),
                                     [](const FrameRecord& f) { return f.pose_stale; });
    EXPECT_NEAR(static_cast<double>(stale), 0.1 * 75.0, 2.5);
    EXPECT_FALSE(r.frames.back().pose_stale);
}

TEST(Session, ASlowFrameIsNoLostHeadset) {
    const RunRecord r = run(scenario_of(150.0, 20));
    for (const FrameRecord& f : r.frames) EXPECT_FALSE(f.pose_stale) << f.frame;
}

/// Of each device one sentence when it is lost and one when it is back, before the frames that
/// follow, and the same in the records.
TEST(Session, SaysAtOnceWhichDeviceIsLostAndWhenItIsBack) {
    Scenario s = scenario_of(10.0, 120);
    s.faults.dk2.unplug_at = 0.7;
    s.faults.dk2.unplug_for = 0.2;
    s.faults.gaze.unplug_at = 1.2;
    s.faults.gaze.unplug_for = 1e3;
    FakeRenderer renderer;
    std::vector<std::string> said;
    std::vector<std::size_t> frames_before;
    std::size_t frames = 0;
    SessionHooks hooks;
    hooks.notice = [&](const std::string& text) {
        said.push_back(text);
        frames_before.push_back(frames);
    };
    hooks.frame_done = [&](const FrameRecord&, const FrameInput&, double) {
        ++frames;
        return false;
    };
    const RunRecord r = run(s, renderer, hooks);
    ASSERT_EQ(said.size(), 3U);
    EXPECT_EQ(said[0].find("dk2 is lost at 0.7"), 0U) << said[0];
    EXPECT_NE(said[0].find("faults.dk2.unplug_at"), std::string::npos) << said[0];
    EXPECT_EQ(said[1].find("dk2 is back at 0.90 s"), 0U) << said[1];
    EXPECT_EQ(said[2].find("gaze is lost at 1.2"), 0U) << said[2];
    const double settled_s = s.settle_s;
    EXPECT_NEAR(static_cast<double>(frames_before[0]), (0.7 - settled_s) * 75.0, 1.5);
    EXPECT_NEAR(static_cast<double>(frames_before[2]), (1.2 - settled_s) * 75.0, 1.5);

    ASSERT_EQ(r.devices[0].outages.size(), 1U);
    const Outage& of_head = r.devices[0].outages[0];
    // Shown by the first frame after it; back with the first report.
    EXPECT_NEAR(to_seconds(of_head.lost.time_since_epoch()), 0.7, 1.0 / 75.0);
    EXPECT_GE(to_seconds(of_head.lost.time_since_epoch()), 0.7);
    ASSERT_TRUE(of_head.back.has_value());
    EXPECT_NEAR(to_seconds(of_head.back->time_since_epoch()), 0.9, 0.002);
    ASSERT_EQ(r.devices[1].outages.size(), 1U);
    EXPECT_FALSE(r.devices[1].outages[0].back.has_value());
}

TEST(Session, SaysWhereItWentOnWithAnOldGaze) {
    Scenario s = scenario_of(10.0, 120);
    s.faults.gaze.unplug_at = 0.7;
    s.faults.gaze.unplug_for = 0.8;
    const RunRecord r = run(s);
    const auto stale = std::count_if(r.frames.begin(), r.frames.end(),
                                     [](const FrameRecord& f) { return f.gaze_stale; });
    // From a photon 0.5 s after the last sample (GazeFilterConfig::hold_limit) until the next one
    // arrives; gaze to photon is some 0.06 s.
    EXPECT_NEAR(static_cast<double>(stale), (0.3 + 0.06) * 75.0, 3.0);
    EXPECT_FALSE(r.frames.front().gaze_stale);
    EXPECT_FALSE(r.frames.back().gaze_stale);
}

TEST(Session, HoldsTheGazeOverABlink) {
    Scenario s = scenario_of(10.0, 300);
    s.motion.gaze = "scan";
    s.faults.gaze.blink = 60.0;  // per minute
    const RunRecord r = run(s);
    const auto held = std::count_if(r.frames.begin(), r.frames.end(),
                                    [](const FrameRecord& f) { return f.gaze_held; });
    EXPECT_GT(held, 0);
    EXPECT_LT(held, 200);
}

TEST(Session, CountsSamplesAtTheirRates) {
    const RunRecord r = run(scenario_of(10.0, 75));
    EXPECT_NEAR(r.devices[0].rate_hz.value_or(0.0), 1000.0, 5.0);
    EXPECT_NEAR(r.devices[1].rate_hz.value_or(0.0), 60.0, 1.0);
    EXPECT_EQ(r.devices[0].counts.lost, 0U);
}

TEST(Session, SetsTheGazeTrackersRate) {
    Scenario s = scenario_of(10.0, 75);
    s.tracking.gaze_rate_hz = 250;
    const RunRecord r = run(s);
    EXPECT_NEAR(r.devices[1].rate_hz.value_or(0.0), 250.0, 1.0);
    for (const FrameRecord& f : r.frames) {
        ASSERT_TRUE(f.gaze);
        // At most a period, 12 ms in the tracker and 1 ms on USB.
        EXPECT_LT(to_ms(f.begin - f.gaze->taken), 1000.0 / 250.0 + 13.5);
    }
}

// The panel reads its corner pixel back over HID (DEVICES.md 1.7): what it says must agree with
// what the panel model knows.
TEST(Session, AgreesWithThePanelsReadBack) {
    std::size_t read = 0;
    for (const FrameRecord& f : run(scenario_of(10.0, 75)).frames) {
        if (!f.readback_scan_out) continue;
        ++read;
        EXPECT_NEAR(to_ms(*f.readback_scan_out - *f.vsync), 0.0, 1.0);
    }
    EXPECT_GT(read, 50U);
}

}  // namespace
}  // namespace foverig
