// The format against bytes put together by hand from the specification, and its reader.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "devices/crc32.h"
#include "devices/recording/mcap_encode.h"
#include "tests/devices/byte_text.h"
#include "tests/devices/recording/small_file.h"

namespace foverig::mcap {
namespace {

using test::bytes_of;

TEST(Mcap, WritesRecordsAsTheSpecificationDrawsThem) {
    Buffer out;
    append(out, Header{.profile = "", .library = "ab"});
    EXPECT_EQ(out, bytes_of("01 0A 00 00 00 00 00 00 00  00 00 00 00  02 00 00 00 61 62"));
    out.clear();
    append(out, Schema{.id = 3, .name = "n", .encoding = "e", .data = "d"});
    EXPECT_EQ(out, bytes_of("03 11 00 00 00 00 00 00 00  03 00  01 00 00 00 6E  01 00 00 00 65  "
                            "01 00 00 00 64"));
    out.clear();
    append(out, Channel{.id = 1,
                        .schema_id = 3,
                        .topic = "t",
                        .message_encoding = "m",
                        .metadata = {{"k", "v"}}});
    EXPECT_EQ(out, bytes_of("04 1C 00 00 00 00 00 00 00  01 00 03 00  01 00 00 00 74  "
                            "01 00 00 00 6D  0A 00 00 00  01 00 00 00 6B 01 00 00 00 76"));
    out.clear();
    const auto data = bytes_of("AA BB");
    append(out, Message{.channel = 1,
                        .sequence = 2,
                        .log_time_ns = 0x0102030405060708,
                        .publish_time_ns = 9,
                        .data = data});
    EXPECT_EQ(out, bytes_of("05 18 00 00 00 00 00 00 00  01 00  02 00 00 00  "
                            "08 07 06 05 04 03 02 01  09 00 00 00 00 00 00 00  AA BB"));
    out.clear();
    append(out, MessageIndex{.channel = 7, .entries = {{1, 2}}});
    EXPECT_EQ(out, bytes_of("07 16 00 00 00 00 00 00 00  07 00  10 00 00 00  "
                            "01 00 00 00 00 00 00 00  02 00 00 00 00 00 00 00"));
    out.clear();
    append_data_end(out, 0x01020304);
    EXPECT_EQ(out, bytes_of("0F 04 00 00 00 00 00 00 00  04 03 02 01"));
}

TEST(Mcap, ChecksumsCoverWhatTheSpecificationSays) {
    const auto file = test::small_file();
    const std::size_t footer = file.size() - kMagic.size() - kFooterSize;
    const std::uint64_t summary = read_u64(file, footer + kRecordHead);
    EXPECT_EQ(read_u32(file, footer + kRecordHead + 16),
              crc32(Bytes(file).subspan(summary, footer + kRecordHead + 16 - summary)));
    const std::size_t data_end = summary - kRecordHead - 4;
    ASSERT_EQ(read_u8(file, data_end), 15);
    EXPECT_EQ(read_u32(file, data_end + kRecordHead), crc32(Bytes(file).first(data_end)));
}

TEST(Mcap, ReadsBackByItsIndex) {
    const auto file = test::small_file();
    const auto lines = test::lines_of(file);
    ASSERT_TRUE(lines) << lines.error().text;
    ASSERT_EQ(lines->size(), test::kLines);
    for (int i = 0; i < test::kLines; ++i) {
        EXPECT_EQ(lines.value()[static_cast<std::size_t>(i)], test::line(i));
    }
    const auto opened = test::open_bytes(file);
    const auto summary = read_summary(*opened);
    ASSERT_TRUE(summary);
    ASSERT_TRUE(summary->statistics);
    EXPECT_EQ(summary->statistics->messages, test::kLines);
    EXPECT_EQ(summary->statistics->messages_of.at(2), 4U);
    EXPECT_EQ(summary->statistics->end_ns, test::line(test::kLines - 1).log_time_ns);
    EXPECT_EQ(summary->channel("/b")->metadata.at("key"), "value");
    const auto note =
        opened->decoded(summary->metadata.at(0).offset, Op::metadata, decode_metadata);
    ASSERT_TRUE(note);
    EXPECT_EQ(note->texts.at("two"), "2");
    const auto scenario =
        opened->decoded(summary->attachments.at(0).offset, Op::attachment, decode_attachment);
    ASSERT_TRUE(scenario);
    EXPECT_EQ(scenario->data.size(), 11U);
    EXPECT_EQ(scenario->create_time_ns, 6U);
}

TEST(Mcap, IgnoresFieldsAndRecordsThatComeWithLaterVersions) {
    Buffer out;
    append(out, Schema{.id = 3, .name = "n", .encoding = "e", .data = "d"});
    out.push_back(std::byte{1});  // a field that we do not know
    const auto schema = decode_schema(Bytes(out).subspan(kRecordHead));
    ASSERT_TRUE(schema);
    EXPECT_EQ(schema->data, "d");
}

TEST(Mcap, NoCutFileIsTakenForAWholeOne) {
    const auto file = test::small_file();
    for (std::size_t size = 0; size < file.size(); ++size) {
        const auto lines = test::lines_of(Bytes(file).first(size));
        ASSERT_FALSE(lines) << size;
        ASSERT_THAT(lines.error().text, testing::StartsWith("test.mcap: ")) << size;
    }
}

TEST(Mcap, AFlippedByteNeverChangesAMessageSilently) {
    const auto good = test::small_file();
    const auto expected = test::lines_of(good).value();
    auto file = good;
    for (std::size_t at = 0; at < file.size(); ++at) {
        for (const std::byte flip : {std::byte{0x01}, std::byte{0x80}, std::byte{0xFF}}) {
            file[at] ^= flip;
            const auto lines = test::lines_of(file);
            ASSERT_TRUE(!lines || *lines == expected) << at;
            file[at] ^= flip;
        }
    }
}

TEST(Crc32, GoesOnFromPartToPartAtAnySplit) {
    std::vector<std::byte> bytes(100);
    std::uint32_t bitwise = 0xFFFFFFFFu;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        bytes[i] = static_cast<std::byte>(i * i + 3);
        bitwise ^= read_u8(bytes, i);
        for (int bit = 0; bit < 8; ++bit)
            bitwise = (bitwise >> 1) ^ ((bitwise & 1u) != 0 ? 0xEDB88320u : 0u);
    }
    for (std::size_t split = 0; split <= bytes.size(); ++split) {
        const auto first = crc32(Bytes(bytes).first(split));
        EXPECT_EQ(crc32(Bytes(bytes).subspan(split), first), ~bitwise) << split;
    }
}

}  // namespace
}  // namespace foverig::mcap
