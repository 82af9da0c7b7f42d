#include "rig/output/run_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <sstream>
#include <system_error>

#include "rig/failure.h"
#include "tests/rig/full_disk.h"

namespace foverig {
namespace fs = std::filesystem;
namespace {

class RunFolderTest : public testing::Test {
  protected:
    void SetUp() override {
        root_ = fs::path(testing::TempDir()) / ("run_folder_test_" + std::to_string(getpid()));
        fs::remove_all(root_);
        fs::create_directories(root_);
    }
    void TearDown() override { fs::remove_all(root_); }

    static std::string text_of(const fs::path& file) {
        std::ostringstream text;
        text << std::ifstream(file).rdbuf();
        return text.str();
    }
    std::size_t entries() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(root_), {}));
    }

    fs::path root_;
};

TEST_F(RunFolderTest, AppearsWholeWhenPublished) {
    {
        RunFolder folder(root_ / "run");
        folder.write("summary.json", "{}");
        EXPECT_FALSE(fs::exists(root_ / "run"));
        folder.publish();
    }
    EXPECT_EQ(text_of(root_ / "run/summary.json"), "{}");
    EXPECT_EQ(entries(), 1U);
}

TEST_F(RunFolderTest, LeavesNothingWhenNotPublished) {
    { RunFolder(root_ / "run").write("summary.json", "{}"); }
    EXPECT_EQ(entries(), 0U);
}

TEST_F(RunFolderTest, TakesThePlaceOfAnOlderRun) {
    for (const char* text : {"old", "new"}) {
        RunFolder folder(root_ / "run/");
        folder.write("summary.json", text);
        folder.publish();
    }
    EXPECT_EQ(text_of(root_ / "run/summary.json"), "new");
    EXPECT_EQ(entries(), 1U);
}

TEST_F(RunFolderTest, RefusesAFolderOfSomethingElse) {
    fs::create_directories(root_ / "photos");
    write_text(root_ / "photos/cat.png", "cat");
    EXPECT_THROW(RunFolder(root_ / "photos"), UsageError);
    EXPECT_THROW(RunFolder(root_ / "photos/cat.png"), UsageError);
    EXPECT_THROW(RunFolder(root_ / "photos/cat.png/run"), UsageError);
    EXPECT_EQ(text_of(root_ / "photos/cat.png"), "cat");
}

TEST_F(RunFolderTest, RescuesOfOneProcessNumberLieBesideEachOther) {
    std::vector<fs::path> kept;
    for (const char* text : {"first", "second", "third"}) {
        const RunFolder folder(root_ / "run");
        folder.write("session.mcap", text);
        const auto place = folder.rescue("session.mcap");
        ASSERT_TRUE(place) << text;
        kept.push_back(*place);
    }
    const std::string stem = "run.failed-" + std::to_string(getpid());
    EXPECT_EQ(kept[0], root_ / (stem + ".mcap"));
    EXPECT_EQ(kept[1], root_ / (stem + "-2.mcap"));
    EXPECT_EQ(kept[2], root_ / (stem + "-3.mcap"));
    EXPECT_EQ(text_of(kept[0]), "first");
    EXPECT_EQ(text_of(kept[1]), "second");
    EXPECT_EQ(text_of(kept[2]), "third");
    EXPECT_EQ(entries(), 3U);
    EXPECT_FALSE(RunFolder(root_ / "run").rescue("session.mcap")) << "there is none";
}

TEST_F(RunFolderTest, ReplacesATextWholeOrNotAtAll) {
    write_text(root_ / "report.html", "old");
    replace_text(root_ / "report.html", "new");
    EXPECT_EQ(text_of(root_ / "report.html"), "new");
    EXPECT_THROW(replace_text(root_ / "no/such/report.html", "x"), std::runtime_error);
    EXPECT_EQ(entries(), 1U);
}

TEST_F(RunFolderTest, ReplacesWhatALinkLeadsToAndKeepsTheLink) {
    fs::create_directories(root_ / "there");
    write_text(root_ / "there/all.json", "old");
    fs::create_symlink("there/all.json", root_ / "all.json");
    replace_text(root_ / "all.json", "new");
    EXPECT_TRUE(fs::is_symlink(root_ / "all.json"));
    EXPECT_EQ(text_of(root_ / "there/all.json"), "new");
    fs::create_symlink("there/later.json", root_ / "later.json");
    replace_text(root_ / "later.json", "first");
    EXPECT_TRUE(fs::is_symlink(root_ / "later.json"));
    EXPECT_EQ(text_of(root_ / "there/later.json"), "first");
    EXPECT_EQ(entries(), 3U) << "no draft";
}

TEST_F(RunFolderTest, WritesIntoAPipeAndLeavesItThere) {
    const fs::path pipe = root_ / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(reader, 0);
    replace_text(pipe, "through");
    std::array<char, 32> got{};
    EXPECT_EQ(::read(reader, got.data(), got.size()), 7);
    ::close(reader);
    EXPECT_STREQ(got.data(), "through");
    EXPECT_TRUE(fs::is_fifo(pipe));
    EXPECT_EQ(entries(), 1U);
}

TEST_F(RunFolderTest, RemovesTheDraftOfWhatCannotBeReplaced) {
    fs::create_directories(root_ / "folder/within");
    EXPECT_THROW(replace_text(root_ / "folder", "x"), std::system_error);
    EXPECT_EQ(entries(), 1U);
    write_text(root_ / "report.html", "old");
    {
        const test::FullDisk disk(1000);
        EXPECT_THROW(replace_text(root_ / "report.html", std::string(100'000, 'x')),
                     std::system_error);
    }
    EXPECT_EQ(text_of(root_ / "report.html"), "old");
    EXPECT_EQ(entries(), 2U);
}

}  // namespace
}  // namespace foverig
