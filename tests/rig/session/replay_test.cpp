// A run, recorded, and the replay of the recording.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "rig/failure.h"
#include "rig/records/frames_csv.h"
#include "rig/session/session.h"
#include "simulators/replay/recording.h"
#include "tests/rig/session/fake_renderer.h"

namespace foverig {
namespace {

namespace fs = std::filesystem;

class Replay : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) / fmt::format("replay_test_{}", getpid());
        fs::create_directories(folder_);
        scene_.camera_path = {{vec3(0.0F, 1.6F, 4.0F), vec3(0.0F, 1.6F, 0.0F)}};
        scenario_.cost = "fixed:7.3";
        scenario_.frames = 120;
        scenario_.faults.dk2.noise = 1.0;
        scenario_.faults.dk2.clock_drift = 50.0;
        scenario_.faults.dk2.dropout = 0.02;
        scenario_.faults.dk2.host_delay = 0.3;
        scenario_.faults.gaze.dropout = 0.05;
        scenario_.faults.gaze.crc_error = 0.05;
        scenario_.faults.gaze.latency_jitter = 2.0;
    }
    void TearDown() override { fs::remove_all(folder_); }

    RunRecord run(const Scenario& scenario, SessionRecording* recording = nullptr) {
        FakeRenderer renderer;
        return Session(scenario, scene_, renderer, nullptr, recording).run({});
    }
    RunRecord record() {
        SessionRecording recording(file(), scenario_);
        return run(scenario_, &recording);
    }
    Scenario replaying() const {
        Scenario s = scenario_;
        s.devices = "replay:" + file().string();
        return s;
    }
    fs::path file() const { return folder_ / "session.mcap"; }

    fs::path folder_;
    Scene scene_;
    Scenario scenario_;
};

/// What needs the truth, or this run's own panel, is absent in a replay; nothing else may differ.
std::vector<FrameRecord> without_truth(std::vector<FrameRecord> frames) {
    for (FrameRecord& frame : frames) {
        frame.prediction_error_deg.reset();
        frame.gaze_error_deg.reset();
        frame.true_head_speed_deg_s.reset();
        frame.head_lag_ms.reset();
        frame.readback_scan_out.reset();
    }
    return frames;
}

std::string csv(const RunRecord& run) {
    return frames_csv(without_truth(run.frames), WallTimes::omit);
}

TEST_F(Replay, GivesTheSamePosesAndGazeBitForBit) {
    const RunRecord first = record();
    const RunRecord again = run(replaying());
    ASSERT_EQ(again.frames.size(), first.frames.size());
    for (std::size_t i = 0; i < first.frames.size(); ++i) {
        EXPECT_EQ(again.frames[i].world_from_head, first.frames[i].world_from_head) << i;
        EXPECT_EQ(again.frames[i].gaze_direction, first.frames[i].gaze_direction) << i;
    }
    EXPECT_EQ(csv(again), csv(first)) << "and every instant";
    EXPECT_EQ(frames_csv(again.frames, WallTimes::omit), csv(again)) << "no truth is made up";
    for (std::size_t device = 0; device < 2; ++device) {
        EXPECT_EQ(again.devices[device].counts.samples, first.devices[device].counts.samples);
        EXPECT_EQ(again.devices[device].counts.lost, first.devices[device].counts.lost);
        EXPECT_EQ(again.devices[device].counts.rejected, first.devices[device].counts.rejected);
    }
}

TEST_F(Replay, StaysTheSameThroughAnUnpluggedHeadset) {
    scenario_.faults.dk2.unplug_at = 0.9;
    scenario_.faults.dk2.unplug_for = 0.4;
    const RunRecord first = record();
    EXPECT_EQ(first.devices[0].counts.reconnects, 1U);
    EXPECT_EQ(csv(run(replaying())), csv(first));
}

TEST_F(Replay, RecordingChangesNothing) {
    const RunRecord first = run(scenario_);
    const RunRecord recorded = record();
    EXPECT_EQ(frames_csv(recorded.frames, WallTimes::omit),
              frames_csv(first.frames, WallTimes::omit));
    ASSERT_TRUE(recorded.recording);
    EXPECT_EQ(recorded.recording->dropped, 0U);
    EXPECT_EQ(recorded.recording->bytes, fs::file_size(file()));
}

TEST_F(Replay, EndsWithTheRecording) {
    record();
    Scenario longer = replaying();
    longer.frames = 1000;
    const RunRecord run_out = run(longer);
    EXPECT_GE(run_out.frames.size(), 120U);
    EXPECT_LE(run_out.frames.size(), 130U) << "the recording's tail of 60 ms";
    longer.replay.loop = true;
    longer.frames = 400;
    const RunRecord looped = run(longer);
    EXPECT_EQ(looped.frames.size(), 400U);
    EXPECT_GE(looped.devices[0].counts.reconnects, 2U) << "a loop looks like a device restarting";
    EXPECT_GT(looped.devices[1].counts.samples, 2 * run_out.devices[1].counts.samples);
}

TEST_F(Replay, HoldsEveryFrameOnceAndTheScenario) {
    const RunRecord first = record();
    const Recording recording = Recording::open(file()).value();
    const mcap::Channel* frames = recording.summary().channel("/frames");
    ASSERT_NE(frames, nullptr);
    EXPECT_EQ(recording.summary().statistics->messages_of.at(frames->id), 120U);
    EXPECT_EQ(
        recording.summary().statistics->messages_of.at(recording.summary().channel("/dk2/imu")->id),
        first.devices[0].counts.samples);
    EXPECT_TRUE(recording.attachment("scenario.toml"));
    for (const char* note : {"foverig.build", "foverig.session", "foverig.calibration.dk2",
                             "foverig.calibration.gaze", "foverig.recorder"}) {
        EXPECT_TRUE(recording.metadata(note)) << note;
    }
}

TEST_F(Replay, SaysWhatIsWrongWithAFile) {
    record();
    fs::resize_file(file(), fs::file_size(file()) / 2);
    EXPECT_THROW(run(replaying()), InputError);
    EXPECT_THROW(SessionRecording(folder_ / "missing" / "a.mcap", scenario_), std::runtime_error);
}

}  // namespace
}  // namespace foverig
