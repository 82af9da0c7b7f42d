#pragma once
// A small recording with two topics in three chunks, an attachment and metadata, and what is in it.
#include <fmt/format.h>

#include "devices/recording/mcap_writer.h"
#include "devices/recording/message_stream.h"
#include "tests/devices/recording/memory_sink.h"

namespace foverig::test {

struct Line {
    std::string topic;
    std::uint32_t sequence = 0;
    std::uint64_t log_time_ns = 0, publish_time_ns = 0;
    std::string data;
    bool operator==(const Line&) const = default;
    friend void PrintTo(const Line& line, std::ostream* out) {
        *out << fmt::format("{} {} {} {} \"{}\"", line.topic, line.sequence, line.log_time_ns,
                            line.publish_time_ns, line.data);
    }
};

inline Line line(int i) {
    return {i % 3 == 0 ? "/b" : "/a", static_cast<std::uint32_t>(i),
            1'000'000'000ULL + static_cast<std::uint64_t>(i) * 7'000'000,
            900'000'000ULL + static_cast<std::uint64_t>(i) * 7'000'000,
            fmt::format("message {} {}", i, std::string(static_cast<std::size_t>(i % 5), '*'))};
}

inline constexpr int kChunks = 3, kLinesPerChunk = 4, kLines = kChunks * kLinesPerChunk;

inline std::vector<std::byte> small_file(mcap::Compression compression = mcap::Compression::none) {
    Disk disk;
    auto writer = mcap::Writer::begin(std::make_unique<MemorySink>(disk), compression).value();
    bool good = true;
    const auto add = [&](const auto& record) { good = good && writer.add(record); };
    add(mcap::Schema{.id = 1, .name = "S", .encoding = "jsonschema", .data = "{}"});
    add(mcap::Channel{
        .id = 1, .schema_id = 1, .topic = "/a", .message_encoding = "json", .metadata = {}});
    add(mcap::Channel{.id = 2,
                      .schema_id = 0,
                      .topic = "/b",
                      .message_encoding = "x-hid",
                      .metadata = {{"key", "value"}}});
    add(mcap::Metadata{.name = "note", .texts = {{"one", "1"}, {"two", "2"}}});
    for (int chunk = 0; chunk < kChunks; ++chunk) {
        mcap::ChunkBuilder builder;
        for (int i = chunk * kLinesPerChunk; i < (chunk + 1) * kLinesPerChunk; ++i) {
            const Line l = line(i);
            builder.add({.channel = static_cast<std::uint16_t>(l.topic == "/a" ? 1 : 2),
                         .sequence = l.sequence,
                         .log_time_ns = l.log_time_ns,
                         .publish_time_ns = l.publish_time_ns,
                         .data = std::as_bytes(std::span(l.data))});
        }
        add(builder);
    }
    const std::string text = "frames = 3\n";
    add(mcap::Attachment{.log_time_ns = 5,
                         .create_time_ns = 6,
                         .name = "scenario.toml",
                         .media_type = "application/toml",
                         .data = to_vector(std::as_bytes(std::span(text)))});
    good = good && writer.end();
    return good ? disk.bytes() : std::vector<std::byte>{};
}

inline Result<mcap::RecordFile> open_bytes(Bytes bytes) {
    return mcap::RecordFile::open(std::make_unique<MemorySource>(bytes), "test.mcap");
}

/// All messages by the index, in the order of the file.
inline Result<std::vector<Line>> lines_of(Bytes bytes) {
    const auto file = open_bytes(bytes);
    if (!file) return file.error();
    const auto summary = mcap::read_summary(*file);
    if (!summary) return summary.error();
    std::map<std::uint16_t, std::string> topics;
    std::set<std::uint16_t> all;
    for (const mcap::Channel& c : summary->channels) {
        topics[c.id] = c.topic;
        all.insert(c.id);
    }
    mcap::MessageStream stream(*file, summary->chunks, all);
    std::vector<Line> lines;
    while (true) {
        const auto got = stream.next();
        if (!got) return got.error();
        if (!got->has_value()) return lines;
        const mcap::Message& m = **got;
        lines.push_back({topics[m.channel], m.sequence, m.log_time_ns, m.publish_time_ns,
                         std::string(reinterpret_cast<const char*>(m.data.data()), m.data.size())});
    }
}

}  // namespace foverig::test
