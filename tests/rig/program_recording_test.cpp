// record, replay and recover as their users meet them.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/rig/full_disk.h"
#include "tests/rig/program_bench.h"

namespace foverig {
namespace {

using test::foverig;
using test::FullDisk;
using test::Outcome;
using test::text_of;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class ProgramRecordingTest : public test::ProgramBench {
  protected:
    Outcome record(const std::string& name) {
        return foverig({"record", "--seconds", "1", "--out", (root_ / name).string()});
    }
};

TEST_F(ProgramRecordingTest, RecordsARunAndReplaysItToTheSamePoses) {
    ASSERT_EQ(small_run("first", {"--set", "recording.enabled=true"}).code, 0);
    const Outcome again = foverig(
        {"replay", (root_ / "first/session.mcap").string(), "--out", (root_ / "second").string()});
    ASSERT_EQ(again.code, 0) << again.err;
    int images = 0;
    for (const auto& image : fs::directory_iterator(root_ / "first/images")) {
        EXPECT_TRUE(test::same_bytes(image, root_ / "second/images" / image.path().filename()))
            << image;
        ++images;
    }
    EXPECT_GT(images, 0);
    EXPECT_FALSE(fs::exists(root_ / "second/session.mcap"));
    EXPECT_THAT(text_of(root_ / "first/summary.json"), HasSubstr("session.mcap"));
}

TEST_F(ProgramRecordingTest, RecordsDevicesAlone) {
    const Outcome recorded = record("a.mcap");
    ASSERT_EQ(recorded.code, 0) << recorded.err;
    EXPECT_THAT(recorded.out, HasSubstr("dk2        999 samples, 0 lost"));
    EXPECT_THAT(recorded.out, HasSubstr("0 dropped"));
    const Outcome over_it = record("a.mcap");
    EXPECT_EQ(over_it.code, 2);
    EXPECT_THAT(over_it.err, HasSubstr("is there already"));
    EXPECT_EQ(small_run("run", {"--devices", "replay:" + (root_ / "a.mcap").string()}).code, 0);
}

TEST_F(ProgramRecordingTest, RecordsWhatARunOfAsManyFramesTakes) {
    const std::string file = (root_ / "a.mcap").string();
    ASSERT_EQ(foverig({"record", "--frames", "30", "--out", file}).code, 0);
    const auto frames_of = [&](const char* name) {
        return nlohmann::json::parse(text_of(root_ / name / "summary.json"))["frames"]["rendered"];
    };
    const auto replay = [&](const char* name, const char* frames) {
        return small_run(name, {"--devices", "replay:" + file, "--frames", frames, "--set",
                                "settle_s=0.5", "--set", "images.frames=[]"});
    };
    const Outcome whole = replay("whole", "30");
    ASSERT_EQ(whole.code, 0) << whole.err;
    EXPECT_EQ(frames_of("whole"), 30);
    EXPECT_THAT(whole.err, Not(HasSubstr("ends after")));
    const Outcome more = replay("more", "60");
    ASSERT_EQ(more.code, 0) << more.err;
    EXPECT_LT(frames_of("more"), 40);
    EXPECT_THAT(more.err, HasSubstr("a.mcap: ends after "));
    EXPECT_THAT(more.err, HasSubstr(" of 60 frames\n"));
}

TEST_F(ProgramRecordingTest, NeedsMoreThanItSettlesOn) {
    const std::string file = (root_ / "a.mcap").string();
    const Outcome refused = foverig({"record", "--seconds", "0.5", "--out", file});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.err, testing::MatchesRegex("foverig: --seconds 0.5: [^\n]+\n"));
    EXPECT_FALSE(fs::exists(file));
    const Outcome recorded =
        foverig({"record", "--seconds", "0.5", "--set", "settle_s=0.1", "--out", file});
    ASSERT_EQ(recorded.code, 0) << recorded.err;
    const Outcome none = small_run("none", {"--devices", "replay:" + file, "--set", "settle_s=2"});
    EXPECT_EQ(none.code, 3);
    EXPECT_THAT(none.err, HasSubstr("a.mcap: ends before the first frame"));
    EXPECT_FALSE(fs::exists(root_ / "none"));
}

TEST_F(ProgramRecordingTest, MendsATornFileAndReplaysIt) {
    ASSERT_EQ(record("a.mcap").code, 0);
    fs::copy_file(root_ / "a.mcap", root_ / "torn.mcap");
    fs::resize_file(root_ / "torn.mcap", fs::file_size(root_ / "a.mcap") - 100'000);
    const Outcome torn = foverig({"replay", (root_ / "torn.mcap").string()});
    EXPECT_EQ(torn.code, 3);
    EXPECT_THAT(torn.err, HasSubstr("foverig recover"));
    const Outcome mended = foverig({"recover", (root_ / "torn.mcap").string()});
    ASSERT_EQ(mended.code, 0) << mended.err;
    EXPECT_THAT(mended.out, HasSubstr("saved "));
    EXPECT_THAT(mended.out, HasSubstr("lost "));
    const std::string place = (root_ / "torn.recovered.mcap").string();
    EXPECT_EQ(small_run("run", {"--devices", "replay:" + place}).code, 0);
    EXPECT_THAT(foverig({"recover", place}).out, HasSubstr("nothing to mend"));
    EXPECT_EQ(foverig({"recover", (root_ / "torn.mcap").string()}).code, 2) << "never over a file";
}

TEST_F(ProgramRecordingTest, KeepsWhatDevicesSentWhenTheRunFails) {
    Outcome outcome;
    {
        const FullDisk disk(100'000);
        outcome = small_run("run", {"--frames", "300", "--set", "recording.enabled=true"});
    }
    EXPECT_NE(outcome.code, 0);
    EXPECT_THAT(outcome.err, HasSubstr("what its devices sent is kept in "));
    EXPECT_FALSE(fs::exists(root_ / "run"));
    std::vector<fs::path> left;
    for (const auto& entry : fs::directory_iterator(root_)) left.push_back(entry);
    ASSERT_EQ(left.size(), 1U) << outcome.err;
    const Outcome mended = foverig({"recover", left[0].string()});
    EXPECT_THAT(mended.out, HasSubstr("saved ")) << mended.err;
}

TEST_F(ProgramRecordingTest, LeavesNoRecordingOfDevicesThatCannotBeOpened) {
    const std::string file = (root_ / "a.mcap").string();
    const Outcome outcome =
        foverig({"record", "--seconds", "1", "--out", file, "--set",
                 "tracking.gaze_calibration=" + (root_ / "missing.json").string()});
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_FALSE(fs::exists(file));
    EXPECT_EQ(small_run("run", {"--set", "recording.enabled=true", "--set",
                                "tracking.gaze_calibration=" + (root_ / "missing.json").string()})
                  .code,
              3);
    EXPECT_TRUE(fs::is_empty(root_));
}

TEST_F(ProgramRecordingTest, SaysWhereAFileCannotBeMade) {
    std::ofstream(root_ / "file") << "no folder\n";
    const Outcome outcome = record("file/a.mcap");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("--out "));
}

TEST_F(ProgramRecordingTest, RefusesToSaveNothing) {
    ASSERT_EQ(record("a.mcap").code, 0);
    fs::resize_file(root_ / "a.mcap", 8);
    const Outcome outcome = foverig({"recover", (root_ / "a.mcap").string()});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("nothing to save"));
    EXPECT_FALSE(fs::exists(root_ / "a.recovered.mcap"));
}

TEST_F(ProgramRecordingTest, BlamesADamagedFileNotTheDevice) {
    ASSERT_EQ(record("a.mcap").code, 0);
    std::fstream file(root_ / "a.mcap", std::ios::binary | std::ios::in | std::ios::out);
    for (int at = 20'000; at < 24'000; at += 100) {
        file.seekp(at);
        file.put('\x5a');
    }
    file.close();
    const Outcome outcome = foverig({"replay", (root_ / "a.mcap").string()});
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("a.mcap"));
}

TEST_F(ProgramRecordingTest, SaysWhatWasLost) {
    const Outcome outcome =
        foverig({"record", "--seconds", "2", "--out", (root_ / "a.mcap").string(), "--set",
                 "faults.gaze.lost_exposure=0.1"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("missed exposures"));
}

TEST_F(ProgramRecordingTest, ExplainsItself) {
    for (const char* command : {"record", "replay", "recover"}) {
        const Outcome help = foverig({command, "--help"});
        EXPECT_EQ(help.code, 0);
        EXPECT_THAT(help.out, HasSubstr(std::string("  foverig ") + command)) << "an example";
    }
    EXPECT_EQ(foverig({"replay"}).code, 2);
}

TEST_F(ProgramRecordingTest, ExitsWithThreeOnWhatIsNoRecording) {
    std::ofstream(root_ / "text.mcap") << "no recording\n";
    for (const fs::path& file : {root_ / "text.mcap", root_ / "missing.mcap", root_}) {
        for (const char* command : {"recover", "replay"}) {
            const Outcome outcome = foverig({command, file.string()});
            EXPECT_EQ(outcome.code, 3) << command << file;
            EXPECT_THAT(outcome.err, testing::MatchesRegex("foverig: [^\n]+\n")) << "one sentence";
        }
        EXPECT_EQ(small_run("run", {"--devices", "replay:" + file.string()}).code, 3);
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(root_), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace foverig
