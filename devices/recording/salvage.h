#pragma once
// Walks a file that may be torn or damaged and hands out every record that holds.
#include <functional>

#include "devices/recording/record_file.h"

namespace foverig::mcap {

struct SalvageCounts {
    std::uint64_t damaged_chunks = 0;
    std::uint64_t lost_messages = 0;  ///< told by the indexes behind damaged chunks
    std::uint64_t skipped_bytes = 0;
    std::optional<RecordPlace> data_end;  ///< the file's end was reached in order
};

/// What is found, in the order of the file.
struct SalvageVisitor {
    std::function<Status(const Schema&)> schema;
    std::function<Status(const Channel&)> channel;
    std::function<Status(const Message&)> message;
    std::function<Status(const Attachment&)> attachment;
    std::function<Status(const Metadata&)> metadata;
};

class Salvage {
  public:
    /// Both outlive this.
    Salvage(const RecordFile& file, const SalvageVisitor& visitor)
        : file_(file), visitor_(visitor) {}

    /// Fails only where the visitor does, or the disk.
    Result<SalvageCounts> run();

  private:
    Status take(const RecordPlace& place);
    Status take_chunk(const RecordPlace& place);
    Result<bool> take_torn_chunk(std::uint64_t offset);
    Status take_records(Bytes records);
    Status take_record(Op op, Bytes content);
    void take_lost_index(Bytes content);
    std::uint64_t next_start(std::uint64_t from);
    bool is_start(Bytes window, std::uint64_t offset);

    const RecordFile& file_;
    const SalvageVisitor& visitor_;
    SalvageCounts counts_;
    bool after_damaged_chunk_ = false;
    std::uint64_t tried_bytes_ = 0;  // of chunks that were tried as starts
    std::vector<std::byte> buffer_, window_, trial_, unpacked_;
};

}  // namespace foverig::mcap
