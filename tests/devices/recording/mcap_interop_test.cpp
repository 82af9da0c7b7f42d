// Our writer and reader against the npm package @mcap/core, indexed and streaming, both ways.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "devices/crc32.h"
#include "devices/recording/file_sink.h"
#include "devices/recording/file_source.h"
#include "devices/recording/recorder.h"
#include "devices/recording/recover.h"
#include "tests/devices/recording/small_file.h"

namespace foverig {
namespace {

namespace fs = std::filesystem;

std::vector<std::byte> content_of(const fs::path& file) {
    const auto source = FileSource::open(file);
    std::vector<std::byte> bytes(source ? source->size() : 0);
    return source && source->read(0, bytes) ? bytes : std::vector<std::byte>{};
}

/// The package in a folder of each test's own, below where the tests run; its versions are pinned
/// by the lock file. Skips where node, npm or the package cannot be had.
class McapInterop : public testing::Test {
  protected:
    void SetUp() override {
        const fs::path ours = fs::path(FOVERIG_SOURCE_DIR) / "tests/devices/recording/interop";
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::path(testing::TempDir()) / "mcap_interop" / test->name();
        fs::create_directories(folder_);
        for (const char* name : {"package.json", "package-lock.json", "interop.mjs"}) {
            fs::copy_file(ours / name, folder_ / name, fs::copy_options::overwrite_existing);
        }
        if (!runs("node --version") || !runs("npm --version")) {
            GTEST_SKIP() << "no node or no npm here";
        }
        const auto installed = [&](const char* package) {
            return fs::exists(folder_ / "node_modules" / package);
        };
        if ((!installed("@mcap/core") || !installed("@foxglove/wasm-zstd")) &&
            !runs("npm ci --no-audit --no-fund")) {
            GTEST_SKIP() << "npm cannot install @mcap/core here";
        }
    }

    bool runs(const std::string& command) const {
        const std::string line = fmt::format("cd '{}' && {} > out.txt 2> err.txt < /dev/null",
                                             folder_.string(), command);
        return std::system(line.c_str()) == 0;
    }

    std::vector<std::string> output() const {
        std::ifstream stream(folder_ / "out.txt");
        std::vector<std::string> lines;
        for (std::string line; std::getline(stream, line);) lines.push_back(line);
        return lines;
    }

    void they_read_what_we_write(mcap::Compression compression) const;
    void we_read_what_they_write(const std::string& kind) const;

    fs::path folder_;
};

void McapInterop::they_read_what_we_write(mcap::Compression compression) const {
    auto sink = FileSink::create(folder_ / "ours.mcap");
    ASSERT_TRUE(sink) << sink.error().text;
    auto recorder =
        Recorder::begin(std::make_unique<FileSink>(std::move(sink).value()),
                        {.chunk_bytes = 4096, .compression = compression, .wait_when_full = true})
            .value();
    const std::array topics{recorder->add_topic({.topic = "/a", .message_encoding = "x-hid"}),
                            recorder->add_topic({.topic = "/b",
                                                 .message_encoding = "json",
                                                 .schema_name = "S",
                                                 .json_schema = R"({"type": "object"})",
                                                 .metadata = {{"key", "value"}}})};
    recorder->attach({.name = "scenario.toml",
                      .media_type = "application/toml",
                      .data = std::vector<std::byte>(11)});
    std::vector<std::string> expected;
    for (int i = 0; i < 3000; ++i) {
        const std::string data = fmt::format("{{\"i\": {}}}{}", i, std::string(i % 11, ' '));
        const auto bytes = std::as_bytes(std::span(data));
        const HostTime time(Nanoseconds(std::int64_t{i} * 1'000'000));
        recorder->record(topics[i % 2], time, time + Nanoseconds(5), bytes);
        expected.push_back(fmt::format("{} {} {} {} {} {}", i % 2 == 0 ? "/a" : "/b", i / 2,
                                       i * 1'000'000LL, i * 1'000'000LL + 5, crc32(bytes),
                                       data.size()));
    }
    ASSERT_TRUE(recorder->close());
    ASSERT_TRUE(runs("node interop.mjs read stream ours.mcap"));
    EXPECT_EQ(output(), expected);
    ASSERT_TRUE(runs("node interop.mjs read index ours.mcap"));
    expected.push_back("attachment scenario.toml 11");
    expected.push_back("metadata foverig.recorder 2");
    EXPECT_EQ(output(), expected);
}

TEST_F(McapInterop, TheyReadWhatWeWrite) {
    they_read_what_we_write(mcap::Compression::none);
}

TEST_F(McapInterop, TheyReadWhatWePack) {
    they_read_what_we_write(mcap::Compression::zstd);
    const auto summary = mcap::read_summary(*test::open_bytes(content_of(folder_ / "ours.mcap")));
    EXPECT_EQ(summary->chunks.at(0).compression, "zstd");
    EXPECT_LT(summary->chunks.at(0).packed_size, summary->chunks.at(0).plain_size);
}

std::vector<test::Line> their_lines(int n) {
    std::vector<test::Line> lines;
    for (int i = 0; i < n; ++i) {
        const auto ns = static_cast<std::uint64_t>(i) * 1'000'000;
        lines.push_back({i % 2 == 0 ? "/even" : "/odd", static_cast<std::uint32_t>(i), ns + 5, ns,
                         fmt::format("{{\"i\":{}}}{}", i, std::string(i % 7, ' '))});
    }
    return lines;
}

void McapInterop::we_read_what_they_write(const std::string& kind) const {
    ASSERT_TRUE(runs("node interop.mjs write " + kind + " theirs.mcap 2000"));
    const auto bytes = content_of(folder_ / "theirs.mcap");
    const auto lines = test::lines_of(bytes);
    ASSERT_TRUE(lines) << lines.error().text;
    EXPECT_EQ(*lines, their_lines(2000));
    const auto file = test::open_bytes(bytes);
    const auto summary = mcap::read_summary(*file);
    EXPECT_EQ(summary->statistics->messages, 2000U);
    const auto attachment = file->decoded(summary->attachments.at(0).offset, mcap::Op::attachment,
                                          mcap::decode_attachment);
    ASSERT_TRUE(attachment) << attachment.error().text;
    EXPECT_EQ(attachment->data.size(), 5U);
    const auto metadata =
        file->decoded(summary->metadata.at(0).offset, mcap::Op::metadata, mcap::decode_metadata);
    EXPECT_EQ(metadata->texts.at("x"), "y");
    EXPECT_EQ(summary->chunks.at(0).compression, kind == "packed" ? "zstd" : "");
}

TEST_F(McapInterop, WeReadWhatTheyWriteByItsIndex) {
    we_read_what_they_write("chunks");
}

TEST_F(McapInterop, WeReadWhatTheyPackByItsIndex) {
    we_read_what_they_write("packed");
}

TEST_F(McapInterop, WeReadWhatTheyWriteFromFrontToBack) {
    ASSERT_TRUE(runs("node interop.mjs write plain theirs.mcap 500"));
    const auto bytes = content_of(folder_ / "theirs.mcap");
    test::Disk mended;
    const auto recovery =
        mcap::recover(*test::open_bytes(bytes), std::make_unique<test::MemorySink>(mended));
    ASSERT_TRUE(recovery) << recovery.error().text;
    EXPECT_TRUE(recovery->losses.empty());
    const auto lines = test::lines_of(mended.bytes());
    ASSERT_TRUE(lines) << lines.error().text;
    EXPECT_EQ(*lines, their_lines(500));
}

}  // namespace
}  // namespace foverig
