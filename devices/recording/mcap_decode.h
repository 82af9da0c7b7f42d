#pragma once
// Contents of MCAP records back into fields. Fields behind the known ones are ignored, as the
// specification asks; a content that ends too early or contradicts itself is invalid_data.
#include "devices/recording/mcap.h"
#include "devices/result.h"

namespace foverig::mcap {

Result<Schema> decode_schema(Bytes content);
Result<Channel> decode_channel(Bytes content);
/// `data` points into `content`, as `records` does.
Result<Message> decode_message(Bytes content);
Result<Chunk> decode_chunk(Bytes content);
Result<MessageIndex> decode_message_index(Bytes content);
Result<ChunkIndex> decode_chunk_index(Bytes content);
/// Its CRC is checked, where it has one.
Result<Attachment> decode_attachment(Bytes content);
Result<AttachmentIndex> decode_attachment_index(Bytes content);
Result<Metadata> decode_metadata(Bytes content);
Result<MetadataIndex> decode_metadata_index(Bytes content);
Result<Statistics> decode_statistics(Bytes content);
Result<Footer> decode_footer(Bytes content);

/// A record of a buffer: its opcode, its content, and where the next one begins.
struct RecordView {
    Op op{};
    Bytes content;
    std::size_t end = 0;
};
/// The record at `at`; invalid_data where it does not fit into `buffer`.
Result<RecordView> record_at(Bytes buffer, std::size_t at);

}  // namespace foverig::mcap
