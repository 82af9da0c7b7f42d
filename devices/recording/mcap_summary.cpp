#include "devices/recording/mcap_summary.h"

#include <fmt/format.h>

#include <algorithm>

#include "devices/crc32.h"

namespace foverig::mcap {
namespace {

constexpr std::size_t kTailSize = kFooterSize + kMagic.size();

Result<Footer> read_footer(const RecordFile& file) {
    const Error torn{ErrorCode::invalid_data,
                     fmt::format("{}: has no end: it is torn or still being written; foverig "
                                 "recover mends it",
                                 file.name())};
    if (file.size() < kMagic.size() + kTailSize) return torn;
    std::vector<std::byte> buffer;
    const std::uint64_t start = file.size() - kTailSize;
    const auto tail = file.bytes(start, kTailSize, buffer);
    if (!tail) return tail.error();
    const auto record = record_at(*tail, 0);
    const Bytes magic = tail->last(kMagic.size());
    if (!record || record->op != Op::footer || record->end != kFooterSize ||
        !std::equal(magic.begin(), magic.end(), kMagic.begin())) {
        return torn;
    }
    auto footer = decode_footer(record->content);
    if (footer && (footer->summary_start < kMagic.size() || footer->summary_start > start)) {
        return file.damaged(start, footer->summary_start == 0
                                       ? "the file has no summary"
                                       : "the summary lies outside of the file");
    }
    return footer;
}

template <class T>
Status add(std::vector<T>& list, Result<T> record) {
    if (!record) return record.error();
    list.push_back(std::move(record).value());
    return Done{};
}

Status take(Summary& summary, const RecordView& record) {
    const Bytes c = record.content;
    switch (record.op) {
        case Op::schema:
            return add(summary.schemas, decode_schema(c));
        case Op::channel:
            return add(summary.channels, decode_channel(c));
        case Op::chunk_index:
            return add(summary.chunks, decode_chunk_index(c));
        case Op::attachment_index:
            return add(summary.attachments, decode_attachment_index(c));
        case Op::metadata_index:
            return add(summary.metadata, decode_metadata_index(c));
        case Op::statistics: {
            const auto statistics = decode_statistics(c);
            if (!statistics) return statistics.error();
            if (statistics->messages > 0 && statistics->end_ns < statistics->start_ns) {
                return Error{ErrorCode::invalid_data,
                             fmt::format("statistics of messages from {} to {} ns, backwards",
                                         statistics->start_ns, statistics->end_ns)};
            }
            summary.statistics = *statistics;
            return Done{};
        }
        default:
            return Done{};  // private and later records are passed over
    }
}

}  // namespace

const Channel* Summary::channel(const std::string& topic) const {
    const auto found = std::find_if(channels.begin(), channels.end(),
                                    [&](const Channel& c) { return c.topic == topic; });
    return found == channels.end() ? nullptr : &*found;
}

Result<Summary> read_summary(const RecordFile& file) {
    const auto footer = read_footer(file);
    if (!footer) return footer.error();
    const std::uint64_t start = footer->summary_start;
    const std::uint64_t end = file.size() - kTailSize;
    std::vector<std::byte> buffer;
    const auto bytes = file.bytes(start, file.size() - start, buffer);
    if (!bytes) return bytes.error();
    const Bytes covered = bytes->first(bytes->size() - kMagic.size() - 4);
    if (footer->summary_crc != 0 && crc32(covered) != footer->summary_crc) {
        return file.damaged(start, "the summary's checksum is wrong");
    }
    Summary summary;
    for (std::size_t at = 0; start + at < end;) {
        const auto record = record_at(bytes->first(static_cast<std::size_t>(end - start)), at);
        if (!record) return file.damaged(start + at, record.error().text);
        if (const auto status = take(summary, *record); !status) {
            return file.damaged(start + at, status.error().text);
        }
        at = record->end;
    }
    if (summary.chunks.empty() && summary.statistics && summary.statistics->messages > 0) {
        return file.damaged(start, "the summary does not index the messages");
    }
    std::stable_sort(summary.chunks.begin(), summary.chunks.end(),
                     [](const ChunkIndex& a, const ChunkIndex& b) { return a.offset < b.offset; });
    return summary;
}

}  // namespace foverig::mcap
