// What a replay takes for the truth of where the eyes look.
#include "rig/session/recorded_gaze.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "devices/gaze/requests.h"
#include "rig/session/angles.h"
#include "rig/session/device_streams.h"
#include "rig/session/panel_settings.h"
#include "rig/session/replayed_world.h"
#include "rig/session/session.h"
#include "rig/session/windowed_world.h"
#include "rig/stats/centre.h"
#include "tests/devices/recording/memory_sink.h"
#include "tests/rig/session/altered_world.h"
#include "tests/rig/session/fake_renderer.h"

namespace foverig {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kFrames = 150;

/// A recording of eyes that scan, by a tracker without faults, whose samples are so the truth.
class RecordedGazeTest : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) / fmt::format("recorded_gaze_{}", getpid());
        fs::create_directories(folder_);
        scene_.camera_path = {{vec3(0.0F, 1.6F, 4.0F), vec3(0.0F, 1.6F, 0.0F)}};
        scenario_.cost = "fixed:7.3";
        scenario_.frames = kFrames;
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path file() const { return folder_ / "session.mcap"; }
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
    RecordedGaze recorded(bool loop) const {
        return {Recording::open(file()).value(), HostTime{}, loop};
    }

    fs::path folder_;
    Scene scene_;
    Scenario scenario_;
};

/// Of each frame's left eye, degrees between what was used and what is known best.
std::vector<double> errors_deg(const RunRecord& run) {
    std::vector<double> errors;
    for (const FrameRecord& frame : run.frames)
        if (frame.best_known_gaze[0])
            errors.push_back(
                angle_deg(dvec3(frame.gaze_direction[0]), dvec3(*frame.best_known_gaze[0])));
    return errors;
}

TEST_F(RecordedGazeTest, IsTheTruthAtTheLightWhereTheTrackerWasRight) {
    const RunRecord first = record();
    const RunRecord again = run(replaying());
    ASSERT_EQ(again.frames.size(), first.frames.size());
    std::vector<double> off_deg;
    double farthest_deg = 0.0;
    for (std::size_t i = 0; i < first.frames.size(); ++i)
        for (const std::size_t eye : {0U, 1U}) {
            const auto& truth = first.frames[i].best_known_gaze[eye];
            const auto& known = again.frames[i].best_known_gaze[eye];
            ASSERT_TRUE(truth) << "simulated eyes are always known";
            farthest_deg = std::max(farthest_deg, angle_deg(dvec3(*truth), dvec3(0.0, 0.0, -1.0)));
            if (known) off_deg.push_back(angle_deg(dvec3(*truth), dvec3(*known)));
        }
    EXPECT_GT(farthest_deg, 5.0) << "the eyes move";
    EXPECT_GT(off_deg.size(), 2U * kFrames * 9U / 10U);
    EXPECT_LT(stats::median_of(off_deg), 0.02) << "the drift between two samples";
    const auto in_saccades =
        std::count_if(off_deg.begin(), off_deg.end(), [](double deg) { return deg > 0.5; });
    EXPECT_LT(static_cast<double>(in_saccades), 0.1 * static_cast<double>(off_deg.size()));
}

TEST_F(RecordedGazeTest, StaysWhatItWasWhereTheTrackerIsMadeWorse) {
    record();
    const RunRecord plain = run(replaying());
    Scenario worse = replaying();
    worse.tracking.gaze_added_latency_ms = 100.0;
    const RunRecord late = run(worse);
    worse.tracking.gaze_added_latency_ms = 0.0;
    worse.tracking.gaze_added_noise_deg = 3.0;
    const RunRecord noisy = run(worse);
    for (const RunRecord* other : {&late, &noisy}) {
        ASSERT_EQ(other->frames.size(), plain.frames.size());
        for (std::size_t i = 0; i < plain.frames.size(); ++i) {
            EXPECT_EQ(other->frames[i].best_known_gaze, plain.frames[i].best_known_gaze) << i;
            EXPECT_EQ(other->frames[i].world_from_head, plain.frames[i].world_from_head) << i;
        }
    }
    const double base_deg = stats::mean_of(errors_deg(plain));
    EXPECT_GT(stats::mean_of(errors_deg(late)), 2.0 * base_deg);
    EXPECT_GT(stats::mean_of(errors_deg(noisy)), base_deg + 0.5);
}

TEST_F(RecordedGazeTest, IsKnownInEveryRoundOfALoop) {
    record();
    const Nanoseconds round = Recording::open(file()).value().round();
    const RecordedGaze once = recorded(false);
    const RecordedGaze looped = recorded(true);
    int known = 0;
    for (int i = 0; i < 200; ++i) {
        const HostTime time(Nanoseconds(7'000'003) * i);
        const auto there = once.at(time);
        EXPECT_EQ(looped.at(time), there) << i;
        EXPECT_EQ(looped.at(time + 2 * round), there) << i;
        EXPECT_FALSE(once.at(time + 2 * round).has_value()) << i;
        known += there.has_value() ? 1 : 0;
    }
    EXPECT_GT(known, 150);
    Scenario scenario = replaying();
    scenario.replay.loop = true;
    scenario.frames = 3 * kFrames;
    const RunRecord run_on = run(scenario);
    const auto unknown = std::count_if(
        run_on.frames.begin(), run_on.frames.end(),
        [](const FrameRecord& frame) { return !frame.best_known_gaze[0].has_value(); });
    EXPECT_LT(unknown, kFrames / 3);
}

TEST_F(RecordedGazeTest, IsKnownInAWindowToo) {
    record();
    ManualClock clock;
    const Scenario scenario = replaying();
    const ReplayedWorld world(scenario, clock);
    const WindowedWorld windowed(
        std::make_unique<ReplayedWorld>(scenario, clock),
        std::make_unique<VirtualPanel>(panel_settings(scenario, clock.now())), false);
    const HostTime time(from_seconds(1.0));
    ASSERT_TRUE(world.best_known_gaze(time).has_value());
    EXPECT_EQ(windowed.best_known_gaze(time), world.best_known_gaze(time));
    EXPECT_EQ(windowed.origin("dk2"), Origin::recorded);
}

/// A tracker that has another rate than the usual one.
class TrackerOf120Hz final : public Transport {
  public:
    explicit TrackerOf120Hz(Transport& device) : device_(device) {}
    NextPacket next(HostTime deadline) override { return device_.next(deadline); }
    Status control_set(std::uint8_t id, std::uint16_t value,
                       std::span<const std::byte> data) override {
        return device_.control_set(id, value, data);
    }
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override {
        auto answer = device_.control_get(id, value, size);
        if (id != gaze::request::get_info || !answer) return answer;
        gaze::Info info = gaze::Info::decode(*answer).value();
        info.rates = 0b010;
        return to_vector(info.encode());
    }

  private:
    Transport& device_;
};

TEST_F(RecordedGazeTest, IsReadAtTheRateThatWasRecorded) {
    Scenario recorded_at = scenario_;
    recorded_at.tracking.gaze_rate_hz = 120;
    {
        ManualClock clock;
        test::AlteredWorld world(recorded_at, clock);
        TrackerOf120Hz tracker(world.gaze_tracker());
        world.gaze_instead = &tracker;
        SessionRecording recording(file(), recorded_at);
        DeviceStreams devices(recorded_at, world, clock, &recording);
        devices.run_for(from_seconds(1.5));
        EXPECT_EQ(recording.end().dropped, 0U);
    }
    ASSERT_EQ(replaying().tracking.gaze_rate_hz, 60);
    EXPECT_TRUE(recorded(false).at(HostTime(from_seconds(1.0))));
    ManualClock clock;
    ReplayedWorld world(replaying(), clock);
    DeviceStreams devices(replaying(), world, clock, nullptr);
    devices.run_for(from_seconds(1.4));
    EXPECT_NEAR(static_cast<double>(devices.gaze().record().counts.samples), 1.4 * 120.0, 4.0);
}

/// Counts what is read of the bytes behind it.
class CountedSource final : public ByteSource {
  public:
    CountedSource(Bytes bytes, std::uint64_t& count) : source_(bytes), count_(count) {}
    std::uint64_t size() const override { return source_.size(); }
    Status read(std::uint64_t offset, std::span<std::byte> out) const override {
        count_ += out.size();
        return source_.read(offset, out);
    }

  private:
    MemorySource source_;
    std::uint64_t& count_;
};

TEST_F(RecordedGazeTest, IsReadNoFurtherThanItIsAskedFor) {
    test::Disk disk;
    {
        scenario_.frames = 900;
        SessionRecording recording(std::make_unique<test::MemorySink>(disk), scenario_);
        run(scenario_, &recording);
    }
    const auto bytes = disk.bytes();
    std::uint64_t count = 0;
    const auto opened =
        Recording::open(std::make_unique<CountedSource>(bytes, count), "counted").value();
    count = 0;
    const RecordedGaze gaze(opened, HostTime{}, false);
    ASSERT_TRUE(gaze.at(HostTime(from_seconds(1.0))));
    EXPECT_LT(count, bytes.size() / 2);
    ASSERT_TRUE(gaze.at(HostTime(from_seconds(11.0))));
    EXPECT_GT(count, bytes.size() / 2);
    ASSERT_TRUE(gaze.at(HostTime(from_seconds(1.0)))) << "what was read is kept";
}

TEST_F(RecordedGazeTest, IsNotKnownBeforeAfterAndInLongGaps) {
    scenario_.faults.gaze.unplug_at = 1.0;
    scenario_.faults.gaze.unplug_for = 0.5;
    record();
    const RecordedGaze gaze = recorded(false);
    const auto at_s = [&](double s) { return gaze.at(HostTime(from_seconds(s))); };
    EXPECT_FALSE(at_s(-1.0).has_value());
    EXPECT_TRUE(at_s(0.9).has_value());
    EXPECT_FALSE(at_s(1.2).has_value());
    EXPECT_TRUE(at_s(2.0).has_value());
    EXPECT_FALSE(at_s(60.0).has_value());
}

}  // namespace
}  // namespace foverig
