#pragma once
// Records of an MCAP file, version 0 (mcap.dev/spec): what they hold, not how they lie in bytes.
// Times are ns; offsets count from the file's first byte.
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "devices/bytes.h"

namespace foverig::mcap {

constexpr std::array<std::byte, 8> kMagic{std::byte{0x89}, std::byte{'M'}, std::byte{'C'},
                                          std::byte{'A'},  std::byte{'P'}, std::byte{'0'},
                                          std::byte{'\r'}, std::byte{'\n'}};

enum class Op : std::uint8_t {
    header = 1,
    footer,
    schema,
    channel,
    message,
    chunk,
    message_index,
    chunk_index,
    attachment,
    attachment_index,
    statistics,
    metadata,
    metadata_index,
    summary_offset,
    data_end
};

constexpr std::size_t kRecordHead = 9;  ///< opcode, u64 length of the content
constexpr std::size_t kMessageHead = kRecordHead + 22;
constexpr std::size_t kFooterSize = kRecordHead + 20;

using Texts = std::map<std::string, std::string>;

struct Header {
    std::string profile, library;
};

struct Schema {
    std::uint16_t id = 0;  ///< never 0
    std::string name, encoding, data;
    bool operator==(const Schema&) const = default;
};

struct Channel {
    std::uint16_t id = 0;
    std::uint16_t schema_id = 0;  ///< 0: none
    std::string topic, message_encoding;
    Texts metadata;
    bool operator==(const Channel&) const = default;
};

struct Message {
    std::uint16_t channel = 0;
    std::uint32_t sequence = 0;
    std::uint64_t log_time_ns = 0, publish_time_ns = 0;
    Bytes data;  ///< borrowed
};

struct Chunk {
    std::uint64_t start_ns = 0, end_ns = 0;
    std::uint64_t plain_size = 0;
    std::uint32_t plain_crc = 0;  ///< 0: none
    std::string compression;      ///< "": none
    Bytes records;                ///< borrowed
};

struct MessageIndex {
    struct Entry {
        std::uint64_t log_time_ns, offset;  ///< offset in the chunk's records
    };
    std::uint16_t channel = 0;
    std::vector<Entry> entries;
};

struct ChunkIndex {
    std::uint64_t start_ns = 0, end_ns = 0;
    std::uint64_t offset = 0, length = 0;  ///< of the whole chunk record
    std::map<std::uint16_t, std::uint64_t> message_index_offsets;
    std::uint64_t message_index_length = 0;
    std::string compression;
    std::uint64_t packed_size = 0, plain_size = 0;
};

struct Attachment {
    std::uint64_t log_time_ns = 0, create_time_ns = 0;
    std::string name, media_type;
    std::vector<std::byte> data;
};

struct AttachmentIndex {
    std::uint64_t offset = 0, length = 0;  ///< of the whole record
    std::uint64_t log_time_ns = 0, create_time_ns = 0, data_size = 0;
    std::string name, media_type;
};

struct Metadata {
    std::string name;
    Texts texts;
};

struct MetadataIndex {
    std::uint64_t offset = 0, length = 0;  ///< of the whole record
    std::string name;
};

struct Statistics {
    std::uint64_t messages = 0;
    std::uint16_t schemas = 0;
    std::uint32_t channels = 0, attachments = 0, metadata = 0, chunks = 0;
    std::uint64_t start_ns = 0, end_ns = 0;  ///< of log times; 0 without messages
    std::map<std::uint16_t, std::uint64_t> messages_of;
};

struct SummaryOffset {
    Op group{};
    std::uint64_t start = 0, length = 0;
};

struct Footer {
    std::uint64_t summary_start = 0;         ///< 0: no summary
    std::uint64_t summary_offset_start = 0;  ///< 0: no offsets
    std::uint32_t summary_crc = 0;           ///< 0: none
};

}  // namespace foverig::mcap
