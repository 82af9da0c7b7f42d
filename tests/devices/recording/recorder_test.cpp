#include "devices/recording/recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "devices/recording/recover.h"
#include "tests/devices/recording/small_file.h"

namespace foverig {
namespace {

using test::Disk;
using test::MemorySink;

constexpr Nanoseconds kNever{3'600'000'000'000};

HostTime at_ms(int ms) {
    return HostTime(Nanoseconds(std::int64_t{ms} * 1'000'000));
}

std::unique_ptr<Recorder> recorder_on(
    Disk& disk, const RecorderConfig& config,
    std::function<Status()> before_write = [] { return Status(Done{}); }) {
    return Recorder::begin(std::make_unique<MemorySink>(disk, std::move(before_write)), config)
        .value();
}

/// A disk that stands until it is told to go on.
class Gate {
  public:
    Status wait() {
        std::unique_lock lock(mutex_);
        moved_.wait(lock, [&] { return open_; });
        return Done{};
    }
    void set(bool open) {
        const std::lock_guard lock(mutex_);
        open_ = open;
        moved_.notify_all();
    }

  private:
    std::mutex mutex_;
    std::condition_variable moved_;
    bool open_ = true;
};

TEST(Recorder, KeepsEveryMessageInOrderWithRunningNumbers) {
    Disk disk;
    auto recorder = recorder_on(disk, {.chunk_bytes = 1000});
    const auto a = recorder->add_topic({.topic = "/a", .message_encoding = "x-hid"});
    const auto b = recorder->add_topic(
        {.topic = "/b", .message_encoding = "json", .schema_name = "S", .json_schema = "{}"});
    const std::array data{std::byte{1}, std::byte{2}};
    for (int i = 0; i < 500; ++i)
        recorder->record(i % 5 == 0 ? b : a, at_ms(i), at_ms(i - 2), data);
    ASSERT_TRUE(recorder->close());
    EXPECT_EQ(recorder->counts().messages, 500U);
    EXPECT_EQ(recorder->counts().dropped, 0U);
    EXPECT_EQ(recorder->counts().bytes, disk.bytes().size());
    const auto lines = test::lines_of(disk.bytes());
    ASSERT_TRUE(lines) << lines.error().text;
    ASSERT_EQ(lines->size(), 500U);
    std::map<std::string, std::uint32_t> next;
    for (std::size_t i = 0; i < 500; ++i) {
        const test::Line& line = lines.value()[i];
        EXPECT_EQ(line.sequence, next[line.topic]++);
        EXPECT_EQ(line.log_time_ns, i * 1'000'000);
        EXPECT_EQ(line.publish_time_ns, i < 2 ? 0 : (i - 2) * 1'000'000) << "never before 0";
    }
}

TEST(Recorder, CountsWhatASlowDiskCostsAndLeavesAGapInTheNumbers) {
    Disk disk;
    Gate gate;
    auto recorder =
        recorder_on(disk, {.chunk_bytes = 200, .queue_bytes = 2000, .flush_period = kNever},
                    [&] { return gate.wait(); });
    const auto a = recorder->add_topic({.topic = "/a", .message_encoding = "x-hid"});
    gate.set(false);
    const std::array<std::byte, 69> data{};  // 100 bytes a record
    for (int i = 0; i < 100; ++i) recorder->record(a, at_ms(i), at_ms(i), data);
    EXPECT_EQ(recorder->counts().messages, 20U) << "what 2000 bytes hold";
    EXPECT_EQ(recorder->counts().dropped, 80U);
    gate.set(true);
    // Everything that was held is written before the queue takes on more than it held.
    while (recorder->counts().messages < 21U) recorder->record(a, at_ms(100), at_ms(100), data);
    const auto counts = recorder->counts();
    ASSERT_TRUE(recorder->close());
    EXPECT_EQ(counts.dropped_of.at("/a"), counts.dropped);
    const auto lines = test::lines_of(disk.bytes());
    ASSERT_TRUE(lines) << lines.error().text;
    ASSERT_EQ(lines->size(), 21U);
    EXPECT_EQ(lines->at(19).sequence, 19U);
    EXPECT_EQ(lines->at(20).sequence, 20U + counts.dropped);
    const auto bytes = disk.bytes();
    const auto again = test::open_bytes(bytes);
    const auto summary = mcap::read_summary(*again);
    const auto note =
        again->decoded(summary->metadata.back().offset, mcap::Op::metadata, mcap::decode_metadata);
    EXPECT_EQ(note->texts.at("dropped"), std::to_string(counts.dropped)) << "the file says so too";
}

TEST(Recorder, WaitsInsteadWhereTimeCanWait) {
    Disk disk;
    auto recorder =
        recorder_on(disk, {.chunk_bytes = 200, .queue_bytes = 500, .wait_when_full = true});
    const auto a = recorder->add_topic({.topic = "/a", .message_encoding = "x-hid"});
    const std::array<std::byte, 700> large{};  // alone more than the queue holds
    for (int i = 0; i < 50; ++i) recorder->record(a, at_ms(i), at_ms(i), large);
    ASSERT_TRUE(recorder->close());
    EXPECT_EQ(recorder->counts().dropped, 0U);
    EXPECT_EQ(test::lines_of(disk.bytes())->size(), 50U);
}

TEST(Recorder, SaysThatTheDiskIsFullAndCountsWhatWasLost) {
    Disk disk;
    std::atomic<bool> full = false;
    auto recorder =
        recorder_on(disk, {.chunk_bytes = 100, .wait_when_full = true}, [&]() -> Status {
            if (full) return Error{ErrorCode::io, "a.mcap: cannot be written: no space"};
            return Done{};
        });
    const auto a = recorder->add_topic({.topic = "/a", .message_encoding = "x-hid"});
    full = true;
    const std::array<std::byte, 100> data{};
    while (recorder->status()) recorder->record(a, at_ms(0), at_ms(0), data);
    recorder->record(a, at_ms(0), at_ms(0), data);
    EXPECT_GE(recorder->counts().dropped, 1U);
    const Status closed = recorder->close();
    ASSERT_FALSE(closed);
    EXPECT_EQ(closed.error().text, "a.mcap: cannot be written: no space");
}

TEST(Recorder, WhatLiesOnTheDiskBeforeItsEndCanBeRecovered) {
    Disk disk;
    auto recorder = recorder_on(disk, {.flush_period = Nanoseconds(1'000'000)});
    const auto a = recorder->add_topic({.topic = "/a", .message_encoding = "x-hid"});
    const std::size_t before = disk.bytes().size();
    const std::array<std::byte, 1000> data{};
    for (int i = 0; i < 10; ++i) recorder->record(a, at_ms(i), at_ms(i), data);
    // Far from a full chunk: only the flush brings it here. The recorder is not closed.
    disk.wait_for(before + 10 * 1031);
    const auto torn = disk.bytes();
    EXPECT_FALSE(test::lines_of(torn));
    Disk mended;
    const auto recovery =
        mcap::recover(*test::open_bytes(torn), std::make_unique<MemorySink>(mended));
    ASSERT_TRUE(recovery) << recovery.error().text;
    EXPECT_EQ(recovery->messages, 10U);
    EXPECT_EQ(test::lines_of(mended.bytes())->size(), 10U);
}

}  // namespace
}  // namespace foverig
