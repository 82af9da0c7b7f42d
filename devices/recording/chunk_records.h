#pragma once
#include "devices/recording/mcap.h"
#include "devices/result.h"

namespace foverig::mcap {

/// A chunk that says that it holds more is refused: ours hold 1 MiB.
constexpr std::uint64_t kLargestUnpacked = std::uint64_t{64} << 20;

/// The records of a chunk's content, their checksum checked; in `buffer` where they were packed. A
/// sentence for what is packed in another way than with zstd (unsupported) or damaged.
Result<Bytes> chunk_records(Bytes content, std::vector<std::byte>& buffer);

}  // namespace foverig::mcap
