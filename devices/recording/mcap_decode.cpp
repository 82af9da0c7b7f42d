#include "devices/recording/mcap_decode.h"

#include <fmt/format.h>

#include "devices/crc32.h"

namespace foverig::mcap {
namespace {

/// Reads fields one behind the other; past the end it gives zeros and remembers.
class Fields {
  public:
    explicit Fields(Bytes content) : rest_(content) {}

    std::uint8_t u8() { return number(1, read_u8); }
    std::uint16_t u16() { return number(2, read_u16); }
    std::uint32_t u32() { return number(4, read_u32); }
    std::uint64_t u64() { return number(8, read_u64); }
    Bytes bytes(std::uint64_t size) {
        if (size > rest_.size()) {
            good_ = false;
            rest_ = {};
            return {};
        }
        const Bytes taken = rest_.first(size);
        rest_ = rest_.subspan(size);
        return taken;
    }
    std::string text() {
        const Bytes b = bytes(u32());
        return {reinterpret_cast<const char*>(b.data()), b.size()};
    }
    Texts texts() {
        Texts texts;
        for (Fields list(bytes(u32())); !list.empty() && good_; good_ = good_ && list.good_) {
            std::string key = list.text();
            texts[std::move(key)] = list.text();
        }
        return texts;
    }
    std::map<std::uint16_t, std::uint64_t> numbers() {
        std::map<std::uint16_t, std::uint64_t> numbers;
        for (Fields list(bytes(u32())); !list.empty() && good_; good_ = good_ && list.good_) {
            const std::uint16_t key = list.u16();
            numbers[key] = list.u64();
        }
        return numbers;
    }
    Bytes rest() { return bytes(rest_.size()); }
    bool empty() const { return rest_.empty(); }
    std::size_t size() const { return rest_.size(); }

    template <class T>
    Result<T> result(T value, const char* record) const {
        if (!good_) {
            return Error{ErrorCode::invalid_data, fmt::format("a {} ends too early", record)};
        }
        return value;
    }

  private:
    template <class Read>
    auto number(std::size_t size, Read read) -> decltype(read(Bytes{}, std::size_t{})) {
        const Bytes b = bytes(size);
        return b.empty() ? 0 : read(b, 0);
    }

    Bytes rest_;
    bool good_ = true;
};

}  // namespace

Result<Schema> decode_schema(Bytes content) {
    Fields f(content);
    Schema s;
    s.id = f.u16();
    s.name = f.text();
    s.encoding = f.text();
    s.data = f.text();
    if (s.id == 0) return Error{ErrorCode::invalid_data, "a schema has id 0"};
    return f.result(std::move(s), "schema");
}

Result<Channel> decode_channel(Bytes content) {
    Fields f(content);
    Channel c;
    c.id = f.u16();
    c.schema_id = f.u16();
    c.topic = f.text();
    c.message_encoding = f.text();
    c.metadata = f.texts();
    return f.result(std::move(c), "channel");
}

Result<Message> decode_message(Bytes content) {
    Fields f(content);
    Message m;
    m.channel = f.u16();
    m.sequence = f.u32();
    m.log_time_ns = f.u64();
    m.publish_time_ns = f.u64();
    m.data = f.rest();
    return f.result(m, "message");
}

Result<Chunk> decode_chunk(Bytes content) {
    Fields f(content);
    Chunk c;
    c.start_ns = f.u64();
    c.end_ns = f.u64();
    c.plain_size = f.u64();
    c.plain_crc = f.u32();
    c.compression = f.text();
    c.records = f.bytes(f.u64());
    if (c.compression.empty() && c.plain_size != c.records.size()) {
        return Error{ErrorCode::invalid_data, "a chunk has another size than it says"};
    }
    return f.result(std::move(c), "chunk");
}

Result<MessageIndex> decode_message_index(Bytes content) {
    Fields f(content);
    MessageIndex index;
    index.channel = f.u16();
    Fields list(f.bytes(f.u32()));
    while (!list.empty()) {
        const std::uint64_t time_ns = list.u64();
        index.entries.push_back({time_ns, list.u64()});
    }
    if (!list.result(Done{}, "")) return list.result(std::move(index), "message index");
    return f.result(std::move(index), "message index");
}

Result<ChunkIndex> decode_chunk_index(Bytes content) {
    Fields f(content);
    ChunkIndex c;
    c.start_ns = f.u64();
    c.end_ns = f.u64();
    c.offset = f.u64();
    c.length = f.u64();
    c.message_index_offsets = f.numbers();
    c.message_index_length = f.u64();
    c.compression = f.text();
    c.packed_size = f.u64();
    c.plain_size = f.u64();
    return f.result(std::move(c), "chunk index");
}

Result<Attachment> decode_attachment(Bytes content) {
    Fields f(content);
    Attachment a;
    a.log_time_ns = f.u64();
    a.create_time_ns = f.u64();
    a.name = f.text();
    a.media_type = f.text();
    const Bytes data = f.bytes(f.u64());
    const Bytes covered = content.first(content.size() - f.size());
    const std::uint32_t crc = f.u32();
    a.data = to_vector(data);
    if (f.result(Done{}, "") && crc != 0 && crc != crc32(covered)) {
        return Error{ErrorCode::invalid_data,
                     fmt::format("the checksum of attachment \"{}\" is wrong", a.name)};
    }
    return f.result(std::move(a), "attachment");
}

Result<AttachmentIndex> decode_attachment_index(Bytes content) {
    Fields f(content);
    AttachmentIndex a;
    a.offset = f.u64();
    a.length = f.u64();
    a.log_time_ns = f.u64();
    a.create_time_ns = f.u64();
    a.data_size = f.u64();
    a.name = f.text();
    a.media_type = f.text();
    return f.result(std::move(a), "attachment index");
}

Result<Metadata> decode_metadata(Bytes content) {
    Fields f(content);
    Metadata m;
    m.name = f.text();
    m.texts = f.texts();
    return f.result(std::move(m), "metadata record");
}

Result<MetadataIndex> decode_metadata_index(Bytes content) {
    Fields f(content);
    MetadataIndex m;
    m.offset = f.u64();
    m.length = f.u64();
    m.name = f.text();
    return f.result(std::move(m), "metadata index");
}

Result<Statistics> decode_statistics(Bytes content) {
    Fields f(content);
    Statistics s;
    s.messages = f.u64();
    s.schemas = f.u16();
    s.channels = f.u32();
    s.attachments = f.u32();
    s.metadata = f.u32();
    s.chunks = f.u32();
    s.start_ns = f.u64();
    s.end_ns = f.u64();
    s.messages_of = f.numbers();
    return f.result(std::move(s), "statistics record");
}

Result<Footer> decode_footer(Bytes content) {
    Fields f(content);
    Footer footer;
    footer.summary_start = f.u64();
    footer.summary_offset_start = f.u64();
    footer.summary_crc = f.u32();
    return f.result(footer, "footer");
}

Result<RecordView> record_at(Bytes buffer, std::size_t at) {
    const Error torn{ErrorCode::invalid_data, "a record does not fit into what holds it"};
    if (at > buffer.size() || buffer.size() - at < kRecordHead) return torn;
    const std::uint64_t size = read_u64(buffer, at + 1);
    if (size > buffer.size() - at - kRecordHead) return torn;
    return RecordView{static_cast<Op>(read_u8(buffer, at)),
                      buffer.subspan(at + kRecordHead, static_cast<std::size_t>(size)),
                      at + kRecordHead + static_cast<std::size_t>(size)};
}

}  // namespace foverig::mcap
