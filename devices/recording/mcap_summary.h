#pragma once
// The index at a file's end: what it holds and where, without reading the rest.
#include "devices/recording/record_file.h"

namespace foverig::mcap {

struct Summary {
    std::vector<Schema> schemas;
    std::vector<Channel> channels;
    std::vector<ChunkIndex> chunks;  ///< in the order of the file
    std::vector<AttachmentIndex> attachments;
    std::vector<MetadataIndex> metadata;
    std::optional<Statistics> statistics;

    /// Nullptr where there is no such topic.
    const Channel* channel(const std::string& topic) const;
};

/// Refuses a file without a footer (torn), without an index of its chunks, or with one that
/// contradicts its checksum or the file's size.
Result<Summary> read_summary(const RecordFile& file);

}  // namespace foverig::mcap
