#include "devices/recording/compression.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "devices/recording/chunk_records.h"
#include "devices/recording/recover.h"
#include "tests/devices/recording/small_file.h"

namespace foverig::mcap {
namespace {

std::vector<test::Line> all_lines() {
    std::vector<test::Line> lines;
    for (int i = 0; i < test::kLines; ++i) lines.push_back(test::line(i));
    return lines;
}

Result<std::vector<test::Line>> mended_lines(Bytes file) {
    test::Disk disk;
    const auto recovery =
        recover(*test::open_bytes(file), std::make_unique<test::MemorySink>(disk));
    if (!recovery) return recovery.error();
    return test::lines_of(disk.bytes());
}

TEST(Compression, PackedChunksReadBackAndAreSmaller) {
    const auto plain = test::small_file(), packed = test::small_file(Compression::zstd);
    EXPECT_LT(packed.size(), plain.size());
    const auto summary = read_summary(*test::open_bytes(packed));
    ASSERT_TRUE(summary) << summary.error().text;
    for (const ChunkIndex& chunk : summary->chunks) {
        EXPECT_EQ(chunk.compression, "zstd");
        EXPECT_LT(chunk.packed_size, chunk.plain_size);
    }
    EXPECT_EQ(test::lines_of(packed).value(), all_lines());
    EXPECT_EQ(mended_lines(packed).value(), all_lines());
}

TEST(Compression, WhatGainsNothingStaysAsItIs) {
    std::vector<std::byte> noise(1000);
    std::uint32_t state = 1;
    for (std::byte& b : noise)
        b = static_cast<std::byte>((state = state * 1664525U + 1013904223U) >> 24U);
    const Chunk chunk{.plain_size = noise.size(), .compression = "", .records = noise};
    EXPECT_EQ(ChunkPacker(Compression::zstd).packed(chunk).compression, "");
    EXPECT_EQ(ChunkPacker(Compression::none).packed(chunk).records.data(), noise.data());
}

/// Of the chunk that is cut, what can still be unpacked is saved too; nothing else is made up.
TEST(Compression, ATornFileKeepsEveryWholeChunkAndNothingButItsOwn) {
    const auto file = test::small_file(Compression::zstd);
    const auto all = all_lines();
    const auto chunks = read_summary(*test::open_bytes(file))->chunks;
    for (std::size_t size = kMagic.size(); size < file.size(); ++size) {
        const auto mended = mended_lines(Bytes(file).first(size));
        ASSERT_TRUE(mended) << mended.error().text;
        const auto whole = std::count_if(
            chunks.begin(), chunks.end(),
            [size](const ChunkIndex& chunk) { return chunk.offset + chunk.length <= size; });
        ASSERT_GE(mended->size(), static_cast<std::size_t>(whole * test::kLinesPerChunk)) << size;
        ASSERT_LE(mended->size(), all.size());
        ASSERT_TRUE(std::equal(mended->begin(), mended->end(), all.begin())) << size;
    }
}

TEST(Compression, AFlippedByteCostsAtMostItsChunk) {
    auto file = test::small_file(Compression::zstd);
    const auto all = all_lines();
    for (std::size_t at = kMagic.size(); at < file.size(); ++at) {
        file[at] ^= std::byte{0x10};
        const auto mended = mended_lines(file);
        if (!mended) {
            ASSERT_THAT(mended.error().text, testing::HasSubstr("compressed")) << at;
        } else {
            ASSERT_GE(mended->size() + test::kLinesPerChunk, all.size()) << at;
            for (const test::Line& line : *mended) {
                // Topics outside of chunks have no checksum of their own.
                const bool is_ours = std::find(all.begin(), all.end(), line) != all.end();
                ASSERT_TRUE(is_ours || line.topic.size() == 2) << at;
            }
        }
        file[at] ^= std::byte{0x10};
    }
}

/// A few bytes of zstd can say a gigabyte of zeros; memory follows what is really unpacked.
TEST(Compression, UnpacksNoMoreThanIsAskedFor) {
    const std::vector<std::byte> zeros(std::size_t{4} << 20);
    ChunkPacker packer(Compression::zstd);
    const Chunk packed =
        packer.packed({.plain_size = zeros.size(), .compression = "", .records = zeros});
    ASSERT_LT(packed.records.size(), 1000U);
    std::vector<std::byte> buffer;
    EXPECT_EQ(unpacked_zstd(packed.records, 100, buffer).size(), 100U);
    EXPECT_EQ(buffer.size(), 100U);
    EXPECT_EQ(unpacked_zstd(packed.records, zeros.size(), buffer).size(), zeros.size());
    EXPECT_LT(unpacked_zstd(packed.records.first(40), zeros.size(), buffer).size(), zeros.size());
}

}  // namespace
}  // namespace foverig::mcap
