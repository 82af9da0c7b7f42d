#include "devices/recording/salvage.h"

#include <algorithm>
#include <optional>

#include "devices/recording/chunk_records.h"
#include "devices/recording/compression.h"

namespace foverig::mcap {
namespace {

constexpr std::uint64_t kWindow = 1 << 20;
constexpr std::uint64_t kStartNeeds = kRecordHead + 44;  // the head of a chunk, a name of 4 letters

/// Opcodes above 0x7F are private: they are passed over. The known ones end with data_end.
bool is_known(Op op) {
    const auto code = static_cast<std::uint8_t>(op);
    return code >= 0x80 || (code > 0 && op <= Op::data_end);
}

struct ChunkStart {
    std::uint64_t head = 0;  ///< before the records
    std::uint64_t size = 0;  ///< of the content, head and records
    std::uint64_t plain_size = 0;
    bool packed = false;
};

/// What `bytes` begin with, where it is a chunk of a kind that can be read.
std::optional<ChunkStart> chunk_start(Bytes bytes) {
    if (bytes.size() < kStartNeeds || static_cast<Op>(read_u8(bytes, 0)) != Op::chunk) return {};
    const std::uint32_t name_size = read_u32(bytes, kRecordHead + 28);
    const ChunkStart start{.head = 40 + std::uint64_t{name_size},
                           .size = read_u64(bytes, 1),
                           .plain_size = read_u64(bytes, kRecordHead + 16),
                           .packed = name_size != 0};
    const Bytes name = bytes.subspan(kRecordHead + 32, 4);
    const Bytes zstd = std::as_bytes(std::span(kZstd, 4));
    if (start.packed && (name_size != 4 || !std::ranges::equal(name, zstd))) return {};
    if (start.size < start.head || start.size > kLargestRecord) return {};
    const std::uint64_t records = read_u64(bytes, kRecordHead + start.head - 8);
    const bool fits =
        records == start.size - start.head &&
        (start.packed ? start.plain_size <= kLargestUnpacked : start.plain_size == records);
    return fits ? std::optional(start) : std::nullopt;
}

}  // namespace

Result<SalvageCounts> Salvage::run() {
    std::uint64_t at = kMagic.size();
    while (at < file_.size() && !counts_.data_end) {
        const auto place = file_.place(at);
        if (place && is_known(place->op) && place->content_size <= kLargestRecord) {
            if (auto status = take(*place); !status) return status.error();
            at = place->end();
            continue;
        }
        after_damaged_chunk_ = false;
        const auto torn = take_torn_chunk(at);
        if (!torn) return torn.error();
        if (*torn) break;
        const std::uint64_t next = next_start(at + 1);
        counts_.skipped_bytes += next - at;
        at = next;
    }
    return counts_;
}

Status Salvage::take(const RecordPlace& place) {
    if (place.op == Op::chunk) return take_chunk(place);
    const bool index = place.op == Op::message_index;
    // Message indexes follow chunks only: behind a private record, that was one before its damage.
    if (!index) after_damaged_chunk_ = place.op > Op::data_end;
    if (place.op == Op::data_end) counts_.data_end = place;
    const bool wanted = place.op == Op::schema || place.op == Op::channel ||
                        place.op == Op::message || place.op == Op::attachment ||
                        place.op == Op::metadata || (index && after_damaged_chunk_);
    if (!wanted) return Done{};
    const auto content = file_.content(place, buffer_);
    if (!content) return content.error();
    if (index) {
        take_lost_index(*content);
        return Done{};
    }
    if (place.op == Op::attachment) {
        const auto attachment = decode_attachment(*content);
        if (attachment) return visitor_.attachment(*attachment);
    } else if (place.op == Op::metadata) {
        const auto metadata = decode_metadata(*content);
        if (metadata) return visitor_.metadata(*metadata);
    } else {
        return take_record(place.op, *content);
    }
    counts_.skipped_bytes += place.end() - place.offset;
    return Done{};
}

Status Salvage::take_chunk(const RecordPlace& place) {
    const auto content = file_.content(place, buffer_);
    if (!content) return content.error();
    const auto records = chunk_records(*content, unpacked_);
    after_damaged_chunk_ = !records;
    if (records) return take_records(*records);
    if (records.error().code == ErrorCode::unsupported) {
        return file_.damaged(place.offset, records.error().text);
    }
    ++counts_.damaged_chunks;
    return Done{};
}

/// The last chunk of a recorder that was killed: its whole messages are good, the rest was never
/// written. No checksum can be tried, so only what ends with the file is believed. False: it is
/// something else.
Result<bool> Salvage::take_torn_chunk(std::uint64_t offset) {
    const std::uint64_t rest = file_.size() - offset;
    if (rest < kStartNeeds || rest > kLargestRecord) return false;
    const auto bytes = file_.bytes(offset, rest, buffer_);
    if (!bytes) return bytes.error();
    const auto start = chunk_start(*bytes);
    if (!start || start->size <= rest - kRecordHead) return false;
    ++counts_.damaged_chunks;
    Bytes records = bytes->subspan(kRecordHead + start->head);
    if (start->packed) records = unpacked_zstd(records, start->plain_size, unpacked_);
    if (auto status = take_records(records); !status) return status.error();
    return true;
}

/// Up to the first record that does not hold.
Status Salvage::take_records(Bytes records) {
    for (std::size_t at = 0; at < records.size();) {
        const auto record = record_at(records, at);
        if (!record) return Done{};
        at = record->end;
        if (auto status = take_record(record->op, record->content); !status) return status;
    }
    return Done{};
}

/// One that may stand in a chunk or beside it.
Status Salvage::take_record(Op op, Bytes content) {
    if (op == Op::message) {
        const auto message = decode_message(content);
        if (message) return visitor_.message(*message);
    } else if (op == Op::channel) {
        const auto channel = decode_channel(content);
        if (channel) return visitor_.channel(*channel);
    } else if (op == Op::schema) {
        const auto schema = decode_schema(content);
        if (schema) return visitor_.schema(*schema);
    }
    return Done{};
}

void Salvage::take_lost_index(Bytes content) {
    const auto index = decode_message_index(content);
    if (index) counts_.lost_messages += index->entries.size();
}

/// The next offset at which a whole chunk with a good checksum begins, or the end of the file.
std::uint64_t Salvage::next_start(std::uint64_t from) {
    for (std::uint64_t at = from; at + kStartNeeds < file_.size(); at += kWindow) {
        const std::uint64_t size = std::min(kWindow + kStartNeeds, file_.size() - at);
        const auto window = file_.bytes(at, size, window_);
        if (!window) return file_.size();
        for (std::uint64_t i = 0; i + kStartNeeds <= size && i < kWindow; ++i) {
            if (is_start(window->subspan(static_cast<std::size_t>(i)), at + i)) return at + i;
        }
    }
    return file_.size();
}

bool Salvage::is_start(Bytes window, std::uint64_t offset) {
    const auto start = chunk_start(window);
    // A file made to look like many chunks at once must not cost more than reading it a few times.
    if (!start || start->size > file_.size() - offset - kRecordHead ||
        tried_bytes_ > 4 * file_.size())
        return false;
    tried_bytes_ += start->size + start->plain_size / 16;
    const auto content = file_.bytes(offset + kRecordHead, start->size, trial_);
    return content && chunk_records(*content, unpacked_);
}

}  // namespace foverig::mcap
