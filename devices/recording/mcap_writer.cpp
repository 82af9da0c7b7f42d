#include "devices/recording/mcap_writer.h"

#include <algorithm>

#include "devices/crc32.h"

namespace foverig::mcap {

Result<Writer> Writer::begin(std::unique_ptr<ByteSink> sink, Compression compression) {
    Writer writer(std::move(sink), compression);
    writer.scratch_.assign(kMagic.begin(), kMagic.end());
    append(writer.scratch_, Header{.profile = "", .library = "foverig"});
    if (auto status = writer.put_scratch(); !status) return status.error();
    return writer;
}

Status Writer::put(Bytes bytes) {
    crc_ = crc32(bytes, crc_);
    offset_ += bytes.size();
    return sink_->write(bytes);
}

Status Writer::put_scratch() {
    auto status = put(scratch_);
    scratch_.clear();
    return status;
}

Status Writer::add(const Schema& schema) {
    append(scratch_, schema);
    schemas_.push_back(schema);
    ++statistics_.schemas;
    return put_scratch();
}

Status Writer::add(const Channel& channel) {
    append(scratch_, channel);
    channels_.push_back(channel);
    ++statistics_.channels;
    return put_scratch();
}

Status Writer::add(const Attachment& attachment) {
    append(scratch_, attachment);
    attachments_.push_back({.offset = offset_,
                            .length = scratch_.size(),
                            .log_time_ns = attachment.log_time_ns,
                            .create_time_ns = attachment.create_time_ns,
                            .data_size = attachment.data.size(),
                            .name = attachment.name,
                            .media_type = attachment.media_type});
    ++statistics_.attachments;
    return put_scratch();
}

Status Writer::add(const Metadata& metadata) {
    append(scratch_, metadata);
    metadata_.push_back({offset_, scratch_.size(), metadata.name});
    ++statistics_.metadata;
    return put_scratch();
}

Status Writer::add(const ChunkBuilder& builder) {
    const Chunk chunk = packer_.packed(builder.chunk());
    append_chunk_head(scratch_, chunk);
    ChunkIndex index{.start_ns = chunk.start_ns,
                     .end_ns = chunk.end_ns,
                     .offset = offset_,
                     .length = scratch_.size() + chunk.records.size(),
                     .message_index_offsets = {},
                     .message_index_length = 0,
                     .compression = chunk.compression,
                     .packed_size = chunk.records.size(),
                     .plain_size = chunk.plain_size};
    if (auto status = put_scratch(); !status) return status;
    if (auto status = put(chunk.records); !status) return status;
    for (const MessageIndex& messages : builder.indexes()) {
        if (messages.entries.empty()) continue;
        index.message_index_offsets[messages.channel] = offset_ + scratch_.size();
        append(scratch_, messages);
    }
    index.message_index_length = scratch_.size();
    chunks_.push_back(std::move(index));
    count(builder, chunk);
    return put_scratch();
}

void Writer::count(const ChunkBuilder& builder, const Chunk& chunk) {
    Statistics& s = statistics_;
    s.start_ns = s.messages == 0 ? chunk.start_ns : std::min(s.start_ns, chunk.start_ns);
    s.end_ns = std::max(s.end_ns, chunk.end_ns);
    s.messages += builder.messages();
    ++s.chunks;
    for (const MessageIndex& messages : builder.indexes()) {
        if (!messages.entries.empty()) s.messages_of[messages.channel] += messages.entries.size();
    }
}

template <class Records>
void Writer::append_group(Op op, const Records& records) {
    if (records.empty()) return;
    const std::size_t start = scratch_.size();
    for (const auto& record : records) append(scratch_, record);
    groups_.push_back({op, offset_ + start, scratch_.size() - start});
}

Status Writer::end() {
    append_data_end(scratch_, crc_);
    if (auto status = put_scratch(); !status) return status;

    Footer footer{.summary_start = offset_, .summary_offset_start = 0, .summary_crc = 0};
    append_group(Op::schema, schemas_);
    append_group(Op::channel, channels_);
    append_group(Op::statistics, std::vector{statistics_});
    append_group(Op::chunk_index, chunks_);
    append_group(Op::attachment_index, attachments_);
    append_group(Op::metadata_index, metadata_);
    footer.summary_offset_start = offset_ + scratch_.size();
    for (const SummaryOffset& group : groups_) append(scratch_, group);
    append_footer(scratch_, footer, crc32(scratch_));
    scratch_.insert(scratch_.end(), kMagic.begin(), kMagic.end());
    if (auto status = put_scratch(); !status) return status;
    return sink_->close();
}

}  // namespace foverig::mcap
