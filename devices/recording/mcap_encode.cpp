#include "devices/recording/mcap_encode.h"

#include "devices/crc32.h"

namespace foverig::mcap {
namespace {

/// Fields one behind the other; the record's length is filled in at its end.
class Record {
  public:
    Record(Buffer& out, Op op) : out_(out), start_(out.size()) {
        u8(static_cast<std::uint8_t>(op));
        u64(0);
    }
    /// `following` bytes of the content are written elsewhere.
    void end(std::uint64_t following = 0) {
        write_u64(out_, start_ + 1, out_.size() - start_ - kRecordHead + following);
    }

    void u8(std::uint8_t v) { write_u8(grown(1), 0, v); }
    void u16(std::uint16_t v) { write_u16(grown(2), 0, v); }
    void u32(std::uint32_t v) { write_u32(grown(4), 0, v); }
    void u64(std::uint64_t v) { write_u64(grown(8), 0, v); }
    void bytes(Bytes b) { out_.insert(out_.end(), b.begin(), b.end()); }
    void text(const std::string& s) {
        u32(static_cast<std::uint32_t>(s.size()));
        bytes(std::as_bytes(std::span(s)));
    }
    /// A list with its length in bytes before it.
    template <class WriteEntries>
    void list(WriteEntries&& write_entries) {
        const std::size_t at = out_.size();
        u32(0);
        write_entries();
        write_u32(out_, at, static_cast<std::uint32_t>(out_.size() - at - 4));
    }
    void texts(const Texts& texts) {
        list([&] {
            for (const auto& [key, value] : texts) {
                text(key);
                text(value);
            }
        });
    }
    void numbers(const std::map<std::uint16_t, std::uint64_t>& numbers) {
        list([&] {
            for (const auto& [key, value] : numbers) {
                u16(key);
                u64(value);
            }
        });
    }
    Bytes content() const { return Bytes(out_).subspan(start_ + kRecordHead); }

  private:
    std::span<std::byte> grown(std::size_t by) {
        out_.resize(out_.size() + by);
        return std::span(out_).last(by);
    }

    Buffer& out_;
    std::size_t start_;
};

}  // namespace

void append(Buffer& out, const Header& header) {
    Record r(out, Op::header);
    r.text(header.profile);
    r.text(header.library);
    r.end();
}

void append(Buffer& out, const Schema& schema) {
    Record r(out, Op::schema);
    r.u16(schema.id);
    r.text(schema.name);
    r.text(schema.encoding);
    r.text(schema.data);
    r.end();
}

void append(Buffer& out, const Channel& channel) {
    Record r(out, Op::channel);
    r.u16(channel.id);
    r.u16(channel.schema_id);
    r.text(channel.topic);
    r.text(channel.message_encoding);
    r.texts(channel.metadata);
    r.end();
}

void append(Buffer& out, const Message& message) {
    Record r(out, Op::message);
    r.u16(message.channel);
    r.u32(message.sequence);
    r.u64(message.log_time_ns);
    r.u64(message.publish_time_ns);
    r.bytes(message.data);
    r.end();
}

void append_chunk_head(Buffer& out, const Chunk& chunk) {
    Record r(out, Op::chunk);
    r.u64(chunk.start_ns);
    r.u64(chunk.end_ns);
    r.u64(chunk.plain_size);
    r.u32(chunk.plain_crc);
    r.text(chunk.compression);
    r.u64(chunk.records.size());
    r.end(chunk.records.size());
}

void append(Buffer& out, const MessageIndex& index) {
    Record r(out, Op::message_index);
    r.u16(index.channel);
    r.list([&] {
        for (const auto& entry : index.entries) {
            r.u64(entry.log_time_ns);
            r.u64(entry.offset);
        }
    });
    r.end();
}

void append(Buffer& out, const ChunkIndex& index) {
    Record r(out, Op::chunk_index);
    r.u64(index.start_ns);
    r.u64(index.end_ns);
    r.u64(index.offset);
    r.u64(index.length);
    r.numbers(index.message_index_offsets);
    r.u64(index.message_index_length);
    r.text(index.compression);
    r.u64(index.packed_size);
    r.u64(index.plain_size);
    r.end();
}

void append(Buffer& out, const Attachment& attachment) {
    Record r(out, Op::attachment);
    r.u64(attachment.log_time_ns);
    r.u64(attachment.create_time_ns);
    r.text(attachment.name);
    r.text(attachment.media_type);
    r.u64(attachment.data.size());
    r.bytes(attachment.data);
    r.u32(crc32(r.content()));
    r.end();
}

void append(Buffer& out, const AttachmentIndex& index) {
    Record r(out, Op::attachment_index);
    r.u64(index.offset);
    r.u64(index.length);
    r.u64(index.log_time_ns);
    r.u64(index.create_time_ns);
    r.u64(index.data_size);
    r.text(index.name);
    r.text(index.media_type);
    r.end();
}

void append(Buffer& out, const Statistics& statistics) {
    Record r(out, Op::statistics);
    r.u64(statistics.messages);
    r.u16(statistics.schemas);
    r.u32(statistics.channels);
    r.u32(statistics.attachments);
    r.u32(statistics.metadata);
    r.u32(statistics.chunks);
    r.u64(statistics.start_ns);
    r.u64(statistics.end_ns);
    r.numbers(statistics.messages_of);
    r.end();
}

void append(Buffer& out, const Metadata& metadata) {
    Record r(out, Op::metadata);
    r.text(metadata.name);
    r.texts(metadata.texts);
    r.end();
}

void append(Buffer& out, const MetadataIndex& index) {
    Record r(out, Op::metadata_index);
    r.u64(index.offset);
    r.u64(index.length);
    r.text(index.name);
    r.end();
}

void append(Buffer& out, const SummaryOffset& offset) {
    Record r(out, Op::summary_offset);
    r.u8(static_cast<std::uint8_t>(offset.group));
    r.u64(offset.start);
    r.u64(offset.length);
    r.end();
}

void append_data_end(Buffer& out, std::uint32_t data_crc) {
    Record r(out, Op::data_end);
    r.u32(data_crc);
    r.end();
}

void append_footer(Buffer& out, const Footer& footer, std::uint32_t crc_before) {
    const std::size_t start = out.size();
    Record r(out, Op::footer);
    r.u64(footer.summary_start);
    r.u64(footer.summary_offset_start);
    r.u32(0);
    r.end();
    const Bytes covered = Bytes(out).subspan(start, kFooterSize - 4);
    write_u32(out, start + kFooterSize - 4, crc32(covered, crc_before));
}

}  // namespace foverig::mcap
