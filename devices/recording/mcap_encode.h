#pragma once
// Whole MCAP records, appended to a buffer: opcode, length, content.
#include "devices/recording/mcap.h"

namespace foverig::mcap {

using Buffer = std::vector<std::byte>;

void append(Buffer& out, const Header& header);
void append(Buffer& out, const Schema& schema);
void append(Buffer& out, const Channel& channel);
void append(Buffer& out, const Message& message);
void append(Buffer& out, const MessageIndex& index);
void append(Buffer& out, const ChunkIndex& index);
void append(Buffer& out, const Attachment& attachment);
void append(Buffer& out, const AttachmentIndex& index);
void append(Buffer& out, const Statistics& statistics);
void append(Buffer& out, const Metadata& metadata);
void append(Buffer& out, const MetadataIndex& index);
void append(Buffer& out, const SummaryOffset& offset);
void append_data_end(Buffer& out, std::uint32_t data_crc);

/// All of a chunk record but the records themselves, which follow it in the file.
void append_chunk_head(Buffer& out, const Chunk& chunk);

/// `crc_before`: of the summary section, whose CRC goes on into the footer's first fields.
void append_footer(Buffer& out, const Footer& footer, std::uint32_t crc_before);

}  // namespace foverig::mcap
