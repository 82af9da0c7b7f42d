#pragma once
#include "devices/recording/mcap.h"

namespace foverig::mcap {

/// Messages of one chunk to come, with their index. `clear` keeps the memory for the next one.
class ChunkBuilder {
  public:
    void add(const Message& message);
    void clear();

    bool empty() const { return messages_ == 0; }
    std::size_t size() const { return records_.size(); }  ///< bytes
    std::uint64_t messages() const { return messages_; }
    /// Points into the builder; computes the CRC anew on each call.
    Chunk chunk() const;
    /// By channel id; those without entries are of channels that have no message here.
    const std::vector<MessageIndex>& indexes() const { return indexes_; }

  private:
    std::vector<std::byte> records_;
    std::vector<MessageIndex> indexes_;
    std::uint64_t messages_ = 0, start_ns_ = 0, end_ns_ = 0;
};

}  // namespace foverig::mcap
