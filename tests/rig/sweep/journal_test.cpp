#include "rig/sweep/journal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "rig/failure.h"

namespace foverig::sweep {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class JournalTest : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) / ("journal_test_" + std::to_string(getpid()));
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        file_ = folder_ / journal_name({});
    }
    void TearDown() override { fs::remove_all(folder_); }

    static Accuracy accuracy(std::size_t point) {
        Accuracy a;
        a.point = point;
        a.errors["flip"] = {0.1, 1.0 / 3.0};
        a.rays["total"] = 5.5;
        return a;
    }

    void write_two() const {
        Journal journal(file_);
        journal.append({{"schema", "foverig.sweep/1"}});
        journal.append(to_json(accuracy(0)));
        journal.append(to_json(accuracy(1)));
    }

    std::string complaint() const {
        try {
            read_journal(file_);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }

    fs::path folder_, file_;
};

TEST_F(JournalTest, GivesBackWhatItWasGiven) {
    write_two();
    const JournalContent content = read_journal(file_);
    ASSERT_EQ(content.accuracies.size(), 2U);
    EXPECT_EQ(content.accuracies[1].errors, accuracy(1).errors) << "to the last bit";
    EXPECT_TRUE(content.has({.point = 1}));
    EXPECT_FALSE(content.has({.point = 2}));
    EXPECT_FALSE(content.has({.point = 1, .repetition = 0}));
    EXPECT_EQ(content.whole_bytes, fs::file_size(file_));
}

TEST_F(JournalTest, GivesBackTimedRunsAndThoseOfOlderPrograms) {
    Times times{.point = 3, .repetition = 1, .frame_ms = {1.0 / 3.0}, .pass_ms = {{"trace", 0.2}}};
    times.elsewhere_processors = 0.25;
    auto older = to_json(times);
    older["repetition"] = 2;
    older.erase("elsewhere_processors");
    {
        Journal journal(file_);
        journal.append({{"schema", "foverig.sweep/1"}});
        journal.append(to_json(times));
        journal.append(older);
    }
    const JournalContent content = read_journal(file_);
    ASSERT_EQ(content.times.size(), 2U);
    EXPECT_EQ(content.times[0].frame_ms, times.frame_ms);
    EXPECT_EQ(content.times[0].elsewhere_processors, 0.25);
    EXPECT_EQ(content.times[1].elsewhere_processors, std::nullopt);
}

TEST_F(JournalTest, CutsOffWhatAKillTore) {
    write_two();
    const auto whole = fs::file_size(file_);
    for (std::uintmax_t torn = whole - 1; torn > whole - 40; --torn) {
        write_two();
        fs::resize_file(file_, torn);
        EXPECT_EQ(read_journal(file_).accuracies.size(), 1U);
        Journal journal(file_);
        EXPECT_LT(fs::file_size(file_), torn);
        journal.append(to_json(accuracy(1)));
        EXPECT_EQ(fs::file_size(file_), whole);
        fs::remove(file_);
    }
    std::ofstream(file_) << "{\"schema\": \"fov";
    EXPECT_TRUE(Journal(file_).content().header.is_null());
}

TEST_F(JournalTest, NamesTheLineThatIsDamaged) {
    std::ofstream(file_) << "{\"schema\":\"foverig.sweep/1\"}\n{\"kind\":\"accuracy\",\"poi\n{}\n";
    EXPECT_THAT(complaint(), testing::HasSubstr("runs.jsonl:2: not a line"));
    std::ofstream(file_) << "{\"schema\":\"foverig.summary/1\"}\n";
    EXPECT_THAT(complaint(), testing::HasSubstr("runs.jsonl:1: not a line"));
    std::ofstream(file_) << "[1,2]\n";
    EXPECT_THAT(complaint(), testing::HasSubstr("runs.jsonl:1: not a line"));
    fs::remove(file_);
    EXPECT_THAT(complaint(), testing::HasSubstr("cannot be read"));
}

TEST_F(JournalTest, IsWrittenByOneProcessAtATime) {
    const Journal first(file_);
    EXPECT_THROW(Journal second(file_), UsageError);
}

}  // namespace
}  // namespace foverig::sweep
