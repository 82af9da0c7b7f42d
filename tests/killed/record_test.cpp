// Issue 4: kill -9 at any moment loses at most one second, and recover mends what is left. Time is
// the recording's own, so that a slow machine changes nothing.
#include <filesystem>

#include "devices/recording/file_source.h"
#include "devices/recording/mcap_summary.h"
#include "simulators/replay/recording.h"
#include "tests/killed/recording_process.h"

namespace foverig {
namespace {

namespace fs = std::filesystem;
using test::ProcessAtTerminal;
using test::RecordingProcess;

constexpr double kMostLost_s = 1.0;

class RecordingFolder : public testing::Test {
  protected:
    void SetUp() override {
        root_ = fs::path(testing::TempDir()) / ("killed_" + std::to_string(getpid()));
        fs::remove_all(root_);
        fs::create_directories(root_);
    }
    void TearDown() override { fs::remove_all(root_); }

    std::string at(const char* name) const { return (root_ / name).string(); }
    static std::string recover(const std::string& file) {
        ProcessAtTerminal recovery({"recover", file});
        EXPECT_EQ(recovery.end(), 0) << recovery.said();
        return recovery.said();
    }
    /// Both devices' bytes are in it, from the start to its last message.
    static double last_s(const std::string& file) {
        const auto recording = Recording::open(file);
        if (!recording) {
            ADD_FAILURE() << recording.error().text;
            return 0.0;
        }
        EXPECT_TRUE(recording->has("dk2"));
        EXPECT_TRUE(recording->has("gaze"));
        EXPECT_LT(to_seconds(recording->first().time_since_epoch()), 0.1);
        return to_seconds(recording->last().time_since_epoch());
    }

    fs::path root_;
};

class KilledRecording : public RecordingFolder, public testing::WithParamInterface<double> {};

TEST_P(KilledRecording, LosesASecondAtMostAndIsMended) {
    RecordingProcess recording(at("a.mcap"));
    ASSERT_TRUE(recording.wait_until_produced(GetParam())) << recording.said();
    ASSERT_EQ(recording.kill(), -SIGKILL);
    const double produced_s = recording.produced_s();
    ASSERT_FALSE(Recording::open(at("a.mcap"))) << "it has no end";

    EXPECT_NE(recover(at("a.mcap")).find("has no end"), std::string::npos);
    const double saved_s = last_s(at("a.recovered.mcap"));
    EXPECT_GE(saved_s, produced_s - kMostLost_s);
    EXPECT_NE(recover(at("a.recovered.mcap")).find("nothing to mend"), std::string::npos);
}

// At other phases of the quarter second after which a chunk is written.
INSTANTIATE_TEST_SUITE_P(AtSeveralMoments, KilledRecording,
                         testing::Values(1.1, 1.15, 1.2, 1.3, 2.3));

class CutRecording : public RecordingFolder {};

/// Killed while it wrote: the file ends within its newest chunk, wherever that is cut.
TEST_F(CutRecording, KeepsWhatStandsBeforeACutInTheNewestChunk) {
    RecordingProcess recording(at("a.mcap"));
    ASSERT_TRUE(recording.wait_until_produced(2.0)) << recording.said();
    ASSERT_EQ(recording.kill(), -SIGKILL);
    recover(at("a.mcap"));
    const auto whole = Recording::open(at("a.recovered.mcap"));
    ASSERT_TRUE(whole);
    const double whole_s = last_s(at("a.recovered.mcap"));
    for (const std::uintmax_t cut : {1U, 100U, 5000U, 60'000U}) {
        const std::string torn = at("torn.mcap"), mended = at("torn.recovered.mcap");
        fs::copy_file(at("a.mcap"), torn, fs::copy_options::overwrite_existing);
        ASSERT_GT(fs::file_size(torn), cut);
        fs::resize_file(torn, fs::file_size(torn) - cut);
        recover(torn);
        // The cut is far less than what a second makes.
        EXPECT_GE(last_s(mended), whole_s - kMostLost_s) << cut;
        EXPECT_LE(last_s(mended), whole_s) << cut;
        fs::remove(mended);
    }
}

}  // namespace
}  // namespace foverig
