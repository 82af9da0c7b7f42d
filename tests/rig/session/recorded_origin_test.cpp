// What a recording says its devices were, and what can be told of recordings that say nothing.
#include "rig/session/recorded_origin.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "rig/session/session_recording.h"

namespace foverig {
namespace {

/// Sends nothing; what is recorded of it is its topic.
class Silent final : public Transport {
  public:
    NextPacket next(HostTime) override { return Timeout{}; }
    Status control_set(std::uint8_t, std::uint16_t, std::span<const std::byte>) override {
        return Done{};
    }
    Result<std::vector<std::byte>> control_get(std::uint8_t, std::uint16_t, std::size_t) override {
        return std::vector<std::byte>{};
    }
};

class RecordedOrigin : public testing::Test {
  protected:
    void SetUp() override {
        file_ =
            std::filesystem::path(testing::TempDir()) /
            (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".mcap");
        std::filesystem::remove(file_);
    }
    void TearDown() override { std::filesystem::remove(file_); }

    Recording recorded(const Scenario& scenario, std::optional<Origin> headset,
                       std::optional<Origin> tracker) {
        Silent device;
        const ManualClock clock;
        SessionRecording recording(file_, scenario);
        recording.headset(device, clock, headset);
        recording.gaze_tracker(device, clock, tracker);
        recording.end();
        return Recording::open(file_).value();
    }

    std::filesystem::path file_;
};

TEST_F(RecordedOrigin, IsWhatTheTopicOfEachDeviceSays) {
    Scenario asked;
    asked.devices = "hardware";
    asked.hardware.head = asked.hardware.gaze = "auto";
    const Recording recording = recorded(asked, Origin::simulated, Origin::hardware);
    EXPECT_EQ(recorded_origin(recording, "dk2"), Origin::simulated);
    EXPECT_EQ(recorded_origin(recording, "gaze"), Origin::hardware);
}

TEST_F(RecordedOrigin, IsWhatTheScenarioAskedForWhereTopicsSayNothing) {
    Scenario asked;
    EXPECT_EQ(recorded_origin(recorded(asked, {}, {}), "dk2"), Origin::simulated);
    std::filesystem::remove(file_);
    asked.devices = "hardware";
    asked.hardware.gaze = "sim";
    const Recording recording = recorded(asked, {}, {});
    EXPECT_EQ(recorded_origin(recording, "dk2"), Origin::hardware);
    EXPECT_EQ(recorded_origin(recording, "gaze"), Origin::simulated);
}

TEST_F(RecordedOrigin, IsUnknownWhereNobodyCanTell) {
    Scenario asked;
    asked.devices = "hardware";
    asked.hardware.head = "auto";
    EXPECT_EQ(recorded_origin(recorded(asked, {}, {}), "dk2"), std::nullopt);
    std::filesystem::remove(file_);
    asked.devices = "replay:older.mcap";
    EXPECT_EQ(recorded_origin(recorded(asked, {}, {}), "dk2"), std::nullopt);
}

// Made before topics said it.
TEST(RecordedOriginOfGoldenRecordings, IsSimulated) {
    const std::filesystem::path folder = FOVERIG_SOURCE_DIR "/tests/recordings";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".mcap") continue;
        const auto recording = Recording::open(entry.path());
        ASSERT_TRUE(recording) << entry.path();
        EXPECT_EQ(recorded_origin(*recording, "dk2"), Origin::simulated) << entry.path();
    }
}

}  // namespace
}  // namespace foverig
