#pragma once
// Mending of torn and damaged MCAP files: everything that can still be read goes, with a new index,
// into another file.
#include <filesystem>

#include "devices/recording/mcap_writer.h"
#include "devices/recording/record_file.h"

namespace foverig::mcap {

struct Recovery {
    bool was_whole = false;      ///< nothing was wrong: index, checksums and end are there
    std::uint64_t messages = 0;  ///< saved
    std::uint64_t attachments = 0, metadata = 0;
    std::uint64_t start_ns = 0, end_ns = 0;  ///< of the saved messages
    std::uint64_t damaged_chunks = 0;
    std::uint64_t lost_messages = 0;  ///< of which the file still says that they were there
    std::uint64_t skipped_bytes = 0;  ///< in which nothing could be told
    bool had_index = false;
    bool had_end = false;  ///< the recorder ended it; false: what it still held was never here
    std::vector<std::string> losses{};  ///< a sentence each; empty: every message is there
};

/// Writes what `file` still holds into `sink`, closed. Fails where that cannot be written.
Result<Recovery> recover(const RecordFile& file, std::unique_ptr<ByteSink> sink);

/// Reads a mended file again, by its index and every message of it, and compares the counts.
Status check_recovered(const RecordFile& mended, const Recovery& expected);

}  // namespace foverig::mcap
