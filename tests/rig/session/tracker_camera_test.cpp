// A run whose head is followed by the simulated tracker camera too, its recording, and the replay.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "rig/failure.h"
#include "rig/session/session.h"
#include "simulators/replay/recording.h"
#include "tests/rig/session/fake_renderer.h"

namespace foverig {
namespace {

namespace fs = std::filesystem;

class TrackerCameraRun : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) / fmt::format("tracker_camera_{}", getpid());
        fs::create_directories(folder_);
        scene_.camera_path = {{vec3(0.0F, 1.6F, 4.0F), vec3(0.0F, 1.6F, 0.0F)}};
        scenario_.cost = "fixed:7.3";
        scenario_.frames = 75;
        scenario_.settle_s = 1.0;
        scenario_.faults.dk2.noise = 1.0;
        scenario_.faults.dk2.clock_drift = 50.0;
        scenario_.faults.camera.noise = 1.0;
        scenario_.tracking.camera = true;
    }
    void TearDown() override { fs::remove_all(folder_); }

    RunRecord run(const Scenario& scenario, SessionRecording* recording = nullptr) {
        FakeRenderer renderer;
        return Session(scenario, scene_, renderer, nullptr, recording).run({});
    }
    fs::path file() const { return folder_ / "session.mcap"; }

    fs::path folder_;
    Scene scene_;
    Scenario scenario_;
};

TEST_F(TrackerCameraRun, CountsTheCameraAmongTheDevices) {
    const RunRecord done = run(scenario_);
    ASSERT_EQ(done.devices.size(), 3u);
    EXPECT_EQ(done.devices[2].name, "camera");
    EXPECT_GT(done.devices[2].counts.samples, 110u);
    EXPECT_EQ(done.devices[2].counts.lost + done.devices[2].counts.rejected, 0u);
    EXPECT_NEAR(done.devices[2].rate_hz.value(), 60.0, 0.5);
    scenario_.tracking.camera = false;
    EXPECT_EQ(run(scenario_).devices.size(), 2u);
}

TEST_F(TrackerCameraRun, RecordedFramesGiveTheSamePosesAgainBitForBit) {
    RunRecord recorded;
    {
        SessionRecording recording(file(), scenario_);
        recorded = run(scenario_, &recording);
        ASSERT_EQ(recorded.recording->dropped, 0u);
        EXPECT_GT(recorded.recording->bytes, 110u * 752 * 480);
    }
    const auto opened = Recording::open(file());
    ASSERT_TRUE(opened);
    EXPECT_TRUE(std::any_of(opened->summary().channels.begin(), opened->summary().channels.end(),
                            [](const auto& channel) { return channel.topic == "/camera/fixes"; }));
    Scenario again = scenario_;
    again.devices = "replay:" + file().string();
    const RunRecord replayed = run(again);
    ASSERT_EQ(replayed.frames.size(), recorded.frames.size());
    for (std::size_t i = 0; i < replayed.frames.size(); ++i) {
        EXPECT_EQ(replayed.frames[i].world_from_head, recorded.frames[i].world_from_head) << i;
        EXPECT_EQ(replayed.frames[i].head_position_m, recorded.frames[i].head_position_m) << i;
    }
    EXPECT_EQ(replayed.devices[2].counts.samples, recorded.devices[2].counts.samples);
}

TEST_F(TrackerCameraRun, ARecordingWithoutFramesSaysSo) {
    scenario_.tracking.camera = false;
    scenario_.frames = 5;
    {
        SessionRecording recording(file(), scenario_);
        run(scenario_, &recording);
    }
    Scenario again = scenario_;
    again.devices = "replay:" + file().string();
    again.tracking.camera = true;
    try {
        run(again);
        FAIL() << "a replay found a camera that was not recorded";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("tracking.camera = false"), std::string::npos);
    }
}

}  // namespace
}  // namespace foverig
