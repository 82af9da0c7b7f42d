#include "devices/recording/recover.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/devices/recording/small_file.h"

namespace foverig::mcap {
namespace {

using test::Disk;
using test::MemorySink;

struct Mended {
    Recovery recovery;
    std::vector<test::Line> lines;
};

/// Recovers, and reads the result with the reader of whole files, as the command does.
Result<Mended> mend(Bytes bytes) {
    const auto file = test::open_bytes(bytes);
    if (!file) return file.error();
    Disk disk;
    auto recovery = recover(*file, std::make_unique<MemorySink>(disk));
    if (!recovery) return recovery.error();
    const auto mended = disk.bytes();
    const auto check = check_recovered(*test::open_bytes(mended), *recovery);
    EXPECT_TRUE(check) << check.error().text;
    return Mended{*recovery, test::lines_of(mended).value()};
}

/// Ends of the message records in the file, found by their content.
std::vector<std::size_t> message_ends(Bytes file) {
    std::vector<std::size_t> ends;
    for (int i = 0; i < test::kLines; ++i) {
        const std::string data = test::line(i).data;
        const auto needle = std::as_bytes(std::span(data));
        const auto found = std::search(file.begin(), file.end(), needle.begin(), needle.end());
        ends.push_back(static_cast<std::size_t>(found - file.begin()) + data.size());
    }
    return ends;
}

TEST(Recover, LeavesAWholeFileAlone) {
    const auto mended = mend(test::small_file());
    ASSERT_TRUE(mended);
    EXPECT_TRUE(mended->recovery.was_whole);
    EXPECT_TRUE(mended->recovery.losses.empty());
    EXPECT_EQ(mended->recovery.messages, test::kLines);
}

TEST(Recover, SavesEveryMessageBeforeTheTearWhereverItIs) {
    const auto file = test::small_file();
    const auto ends = message_ends(file);
    for (std::size_t size = kMagic.size(); size < file.size(); ++size) {
        const auto mended = mend(Bytes(file).first(size));
        ASSERT_TRUE(mended) << size << ": " << mended.error().text;
        EXPECT_FALSE(mended->recovery.was_whole) << size;
        const auto whole = static_cast<std::size_t>(
            std::count_if(ends.begin(), ends.end(), [&](std::size_t end) { return end <= size; }));
        ASSERT_EQ(mended->lines.size(), whole) << size;
        for (std::size_t i = 0; i < whole; ++i) {
            ASSERT_EQ(mended->lines[i], test::line(static_cast<int>(i))) << size;
        }
    }
}

TEST(Recover, LosesAtMostTheChunkThatAFlippedByteIsIn) {
    auto file = test::small_file();
    std::vector<test::Line> all;
    for (int i = 0; i < test::kLines; ++i) all.push_back(test::line(i));
    for (std::size_t at = kMagic.size(); at < file.size(); ++at) {
        for (const std::byte flip : {std::byte{0x01}, std::byte{0x80}, std::byte{0xFF}}) {
            file[at] ^= flip;
            const auto mended = mend(file);
            // A flip in a compression's name asks for what we do not read; it is said, not guessed.
            if (!mended) {
                ASSERT_THAT(mended.error().text, testing::HasSubstr("compressed")) << at;
            } else {
                ASSERT_GE(mended->lines.size() + test::kLinesPerChunk, all.size()) << at;
                for (const test::Line& line : mended->lines) {
                    const bool is_one_of_ours =
                        std::find(all.begin(), all.end(), line) != all.end();
                    // Topics outside of chunks have no checksum of their own.
                    ASSERT_TRUE(is_one_of_ours || line.topic.size() == 2) << at;
                }
                if (mended->lines.size() < all.size()) {
                    ASSERT_FALSE(mended->recovery.losses.empty()) << at;
                    ASSERT_FALSE(mended->recovery.was_whole) << at;
                }
            }
            file[at] ^= flip;
        }
    }
}

TEST(Recover, TellsHowManyMessagesADamagedChunkHad) {
    auto file = test::small_file();
    file[message_ends(file)[5] - 1] ^= std::byte{1};  // in the second chunk
    const auto mended = mend(file);
    ASSERT_TRUE(mended);
    EXPECT_EQ(mended->recovery.damaged_chunks, 1U);
    EXPECT_EQ(mended->recovery.lost_messages, test::kLinesPerChunk);
    EXPECT_EQ(mended->recovery.messages, test::kLines - test::kLinesPerChunk);
    EXPECT_EQ(mended->recovery.attachments, 1U);
}

TEST(Recover, FindsTheNextChunkBehindAStretchOfNoise) {
    auto file = test::small_file();
    const auto ends = message_ends(file);
    // From the first chunk's messages into the second chunk's: heads, lengths and all are gone.
    for (std::size_t at = ends[1]; at < ends[5]; ++at) {
        file[at] = static_cast<std::byte>((at * 2654435761U) >> 13);
    }
    const auto mended = mend(file);
    ASSERT_TRUE(mended);
    ASSERT_EQ(mended->lines.size(), test::kLinesPerChunk);
    for (int i = 0; i < test::kLinesPerChunk; ++i) {
        EXPECT_EQ(mended->lines[static_cast<std::size_t>(i)],
                  test::line(2 * test::kLinesPerChunk + i));
    }
}

TEST(Recover, RefusesWhatIsNoRecording) {
    const std::string text = "this is no recording at all";
    const auto mended = mend(std::as_bytes(std::span(text)));
    ASSERT_FALSE(mended);
    EXPECT_THAT(mended.error().text, testing::HasSubstr("is no recording"));
}

/// A file that says that it is larger than anything must not be believed.
TEST(Recover, AsksForNoMoreMemoryThanTheFileHasBytes) {
    std::vector<std::byte> file(kMagic.begin(), kMagic.end());
    file.resize(200);
    write_u8(file, 8, static_cast<std::uint8_t>(Op::chunk));
    write_u64(file, 9, ~std::uint64_t{0} - 5);
    const auto mended = mend(file);
    ASSERT_TRUE(mended);
    EXPECT_EQ(mended->recovery.messages, 0U);
    write_u64(file, 9, 1000);
    write_u64(file, 8 + kRecordHead + 32, ~std::uint64_t{0});
    EXPECT_TRUE(mend(file));
}

}  // namespace
}  // namespace foverig::mcap
