#include "devices/recording/recover.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "devices/crc32.h"
#include "devices/recording/message_stream.h"
#include "devices/recording/salvage.h"

namespace foverig::mcap {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{1} << 20;

/// Writes what is found, each schema and channel once, messages of known channels only.
class Mended {
  public:
    explicit Mended(Writer writer) : writer_(std::move(writer)) {}

    Status add(const Schema& schema) {
        if (!schemas_.emplace(schema.id).second) return Done{};
        return writer_.add(schema);
    }
    Status add(const Channel& channel) {
        if (channels_.contains(channel.id)) return Done{};
        Channel kept = channel;
        if (!schemas_.contains(kept.schema_id)) kept.schema_id = 0;
        channels_.insert(kept.id);
        return writer_.add(kept);
    }
    Status add(const Message& message) {
        if (!channels_.contains(message.channel)) {
            ++unknown_;
            return Done{};
        }
        chunk_.add(message);
        return chunk_.size() >= kChunkBytes ? flush() : Done{};
    }
    template <class Record>
    Status add(const Record& record) {
        return writer_.add(record);
    }
    Status end() {
        if (auto status = flush(); !status) return status;
        return writer_.end();
    }

    const Statistics& statistics() const { return writer_.statistics(); }
    std::uint64_t unknown() const { return unknown_; }

  private:
    Status flush() {
        if (chunk_.empty()) return Done{};
        auto status = writer_.add(chunk_);
        chunk_.clear();
        return status;
    }

    Writer writer_;
    ChunkBuilder chunk_;
    std::set<std::uint16_t> schemas_, channels_;
    std::uint64_t unknown_ = 0;
};

void name_losses(Recovery& r, const SalvageCounts& counts, std::uint64_t unknown,
                 const std::optional<Statistics>& before) {
    if (counts.damaged_chunks > 0) {
        r.losses.push_back(fmt::format("{} damaged or torn chunk{}", counts.damaged_chunks,
                                       counts.damaged_chunks == 1 ? "" : "s"));
    }
    if (counts.skipped_bytes > 0) {
        r.losses.push_back(
            fmt::format("{} bytes that hold nothing readable", counts.skipped_bytes));
    }
    if (unknown > 0) r.losses.push_back(fmt::format("{} messages of unknown topics", unknown));
    if (r.lost_messages > 0) {
        r.losses.push_back(fmt::format("{} messages that the file speaks of", r.lost_messages));
    }
    if (before && (before->attachments > r.attachments || before->metadata > r.metadata)) {
        r.losses.push_back("attachments or metadata that the index lists");
    }
}

/// Of everything before the end of the data; true where the file has no such checksum.
bool data_checksum_holds(const RecordFile& file, const RecordPlace& data_end) {
    constexpr std::uint64_t kStep = std::uint64_t{1} << 20;
    std::vector<std::byte> buffer;
    const auto content = file.content(data_end, buffer);
    if (!content || content->size() < 4) return false;
    const std::uint32_t expected = read_u32(*content, 0);
    if (expected == 0) return true;
    std::uint32_t crc = 0;
    for (std::uint64_t at = 0; at < data_end.offset; at += kStep) {
        const auto bytes = file.bytes(at, std::min(kStep, data_end.offset - at), buffer);
        if (!bytes) return false;
        crc = crc32(*bytes, crc);
    }
    return crc == expected;
}

}  // namespace

Result<Recovery> recover(const RecordFile& file, std::unique_ptr<ByteSink> sink) {
    auto writer = Writer::begin(std::move(sink));
    if (!writer) return writer.error();
    Mended mended(std::move(writer).value());
    const auto index = read_summary(file);
    // A good index names channels whose own records may be damaged.
    if (index) {
        for (const Schema& schema : index->schemas) {
            if (auto status = mended.add(schema); !status) return status.error();
        }
        for (const Channel& channel : index->channels) {
            if (auto status = mended.add(channel); !status) return status.error();
        }
    }
    const SalvageVisitor visitor{
        .schema = [&](const Schema& r) { return mended.add(r); },
        .channel = [&](const Channel& r) { return mended.add(r); },
        .message = [&](const Message& r) { return mended.add(r); },
        .attachment = [&](const Attachment& r) { return mended.add(r); },
        .metadata = [&](const Metadata& r) { return mended.add(r); },
    };
    const auto counts = Salvage(file, visitor).run();
    if (!counts) return counts.error();
    if (auto status = mended.end(); !status) return status.error();

    const Statistics& now = mended.statistics();
    Recovery r{.messages = now.messages,
               .attachments = now.attachments,
               .metadata = now.metadata,
               .start_ns = now.start_ns,
               .end_ns = now.end_ns,
               .damaged_chunks = counts->damaged_chunks,
               .lost_messages = counts->lost_messages + mended.unknown(),
               .skipped_bytes = counts->skipped_bytes,
               .had_index = static_cast<bool>(index),
               .had_end = counts->data_end.has_value()};
    const auto before = index ? index->statistics : std::nullopt;
    if (before && before->messages > r.messages) r.lost_messages = before->messages - r.messages;
    name_losses(r, *counts, mended.unknown(), before);
    if (r.losses.empty() && counts->data_end && !data_checksum_holds(file, *counts->data_end)) {
        r.losses.push_back("something beside the messages: the data's checksum is wrong");
    }
    r.was_whole = r.had_index && counts->data_end && r.losses.empty();
    return r;
}

Status check_recovered(const RecordFile& mended, const Recovery& expected) {
    const auto summary = read_summary(mended);
    if (!summary) return summary.error();
    std::set<std::uint16_t> all;
    for (const Channel& channel : summary->channels) all.insert(channel.id);
    MessageStream stream(mended, summary->chunks, all);
    std::uint64_t messages = 0;
    while (true) {
        const auto message = stream.next();
        if (!message) return message.error();
        if (!message->has_value()) break;
        ++messages;
    }
    if (messages == expected.messages && summary->attachments.size() == expected.attachments) {
        return Done{};
    }
    return Error{ErrorCode::invalid_data,
                 fmt::format("{}: reads back {} messages of {}; please report this file",
                             mended.name(), messages, expected.messages)};
}

}  // namespace foverig::mcap
