// record, replay and recover as their users meet them.
#include <gmock/gmock.h>

#include "tests/rig/program_bench.h"

namespace foverig {
namespace {

using test::foverig;
using test::Outcome;
using test::text_of;
using testing::HasSubstr;
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
    EXPECT_THAT(recorded.out, HasSubstr("dk2        1499 samples, 0 lost"));
    EXPECT_THAT(recorded.out, HasSubstr("0 dropped"));
    const Outcome over_it = record("a.mcap");
    EXPECT_EQ(over_it.code, 2);
    EXPECT_THAT(over_it.err, HasSubstr("is there already"));
    EXPECT_EQ(small_run("run", {"--devices", "replay:" + (root_ / "a.mcap").string()}).code, 0);
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
