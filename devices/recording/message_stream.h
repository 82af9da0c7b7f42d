#pragma once
#include <set>

#include "devices/recording/mcap_summary.h"

namespace foverig::mcap {

/// Messages of some channels in the order of the file, one chunk in memory at a time. Chunks that
/// have none of them are not read.
class MessageStream {
  public:
    /// `file` outlives the stream.
    MessageStream(const RecordFile& file, std::vector<ChunkIndex> chunks,
                  std::set<std::uint16_t> channels);

    /// Nullopt after the last. The message's data is valid until the next call.
    Result<std::optional<Message>> next();
    void rewind();

  private:
    bool wanted(const ChunkIndex& chunk) const;
    Status load(const ChunkIndex& index);

    const RecordFile* file_;
    std::vector<ChunkIndex> chunks_;
    std::set<std::uint16_t> channels_;
    std::size_t next_chunk_ = 0;
    std::vector<std::byte> buffer_, unpacked_;
    Bytes records_;  // of the chunk in memory
    std::size_t at_ = 0;
};

}  // namespace foverig::mcap
