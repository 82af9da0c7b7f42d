#include "devices/recording/chunk_builder.h"

#include <algorithm>

#include "devices/crc32.h"
#include "devices/recording/mcap_encode.h"

namespace foverig::mcap {

void ChunkBuilder::add(const Message& message) {
    while (indexes_.size() <= message.channel) {
        indexes_.push_back({.channel = static_cast<std::uint16_t>(indexes_.size()), .entries = {}});
    }
    indexes_[message.channel].entries.push_back({message.log_time_ns, records_.size()});
    append(records_, message);
    start_ns_ = empty() ? message.log_time_ns : std::min(start_ns_, message.log_time_ns);
    end_ns_ = std::max(end_ns_, message.log_time_ns);
    ++messages_;
}

void ChunkBuilder::clear() {
    records_.clear();
    for (MessageIndex& index : indexes_) index.entries.clear();
    messages_ = start_ns_ = end_ns_ = 0;
}

Chunk ChunkBuilder::chunk() const {
    return {.start_ns = start_ns_,
            .end_ns = end_ns_,
            .plain_size = records_.size(),
            .plain_crc = crc32(records_),
            .compression = "",
            .records = records_};
}

}  // namespace foverig::mcap
