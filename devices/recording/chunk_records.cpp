#include "devices/recording/chunk_records.h"

#include <fmt/format.h>

#include "devices/crc32.h"
#include "devices/recording/compression.h"
#include "devices/recording/mcap_decode.h"

namespace foverig::mcap {

Result<Bytes> chunk_records(Bytes content, std::vector<std::byte>& buffer) {
    const auto chunk = decode_chunk(content);
    if (!chunk) return chunk.error();
    Bytes records = chunk->records;
    if (chunk->compression == kZstd) {
        if (chunk->plain_size > kLargestUnpacked)
            return Error{ErrorCode::invalid_data, "a chunk says that it unpacks to over 64 MiB"};
        records = unpacked_zstd(chunk->records, chunk->plain_size, buffer);
        if (records.size() != chunk->plain_size)
            return Error{ErrorCode::invalid_data, "a chunk's packed records are damaged"};
    } else if (!chunk->compression.empty()) {
        return Error{ErrorCode::unsupported,
                     fmt::format("a chunk is compressed with {}; expected zstd or none (mcap "
                                 "compress --compression zstd makes such a file)",
                                 chunk->compression)};
    }
    if (chunk->plain_crc != 0 && crc32(records) != chunk->plain_crc) {
        return Error{ErrorCode::invalid_data, "a chunk's checksum is wrong"};
    }
    return records;
}

}  // namespace foverig::mcap
