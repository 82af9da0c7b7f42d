#include "devices/recording/message_stream.h"

#include <algorithm>

#include "devices/recording/chunk_records.h"

namespace foverig::mcap {

MessageStream::MessageStream(const RecordFile& file, std::vector<ChunkIndex> chunks,
                             std::set<std::uint16_t> channels)
    : file_(&file), chunks_(std::move(chunks)), channels_(std::move(channels)) {}

void MessageStream::rewind() {
    next_chunk_ = 0;
    records_ = {};
    at_ = 0;
}

bool MessageStream::wanted(const ChunkIndex& chunk) const {
    // A writer may leave the message indexes out; then any chunk may hold anything.
    return chunk.message_index_offsets.empty() ||
           std::any_of(chunk.message_index_offsets.begin(), chunk.message_index_offsets.end(),
                       [&](const auto& channel_offset) {
                           return channels_.contains(channel_offset.first);
                       });
}

Status MessageStream::load(const ChunkIndex& index) {
    const auto place = file_->place(index.offset);
    if (!place) return place.error();
    if (place->op != Op::chunk) return file_->damaged(index.offset, "no chunk where one should be");
    const auto content = file_->content(*place, buffer_);
    if (!content) return content.error();
    const auto records = chunk_records(*content, unpacked_);
    if (!records) return file_->damaged(index.offset, records.error().text);
    records_ = *records;
    at_ = 0;
    return Done{};
}

Result<std::optional<Message>> MessageStream::next() {
    while (true) {
        while (at_ < records_.size()) {
            const auto record = record_at(records_, at_);
            if (!record)
                return file_->damaged(chunks_[next_chunk_ - 1].offset, record.error().text);
            at_ = record->end;
            if (record->op != Op::message) continue;
            const auto message = decode_message(record->content);
            if (!message) {
                return file_->damaged(chunks_[next_chunk_ - 1].offset, message.error().text);
            }
            if (channels_.contains(message->channel)) return std::optional(*message);
        }
        while (next_chunk_ < chunks_.size() && !wanted(chunks_[next_chunk_])) ++next_chunk_;
        if (next_chunk_ == chunks_.size()) return std::optional<Message>();
        if (auto status = load(chunks_[next_chunk_++]); !status) return status.error();
    }
}

}  // namespace foverig::mcap
