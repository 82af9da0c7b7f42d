#pragma once
// One MCAP file, front to back: records as they come, then the summary. Messages are in chunks;
// schemas and channels are not, so that a damaged chunk takes none of them with it.
#include <memory>

#include "devices/recording/byte_sink.h"
#include "devices/recording/chunk_builder.h"
#include "devices/recording/compression.h"
#include "devices/recording/mcap_encode.h"

namespace foverig::mcap {

class Writer {
  public:
    /// Writes the file's head. After any error the file is torn and nothing more may be written.
    static Result<Writer> begin(std::unique_ptr<ByteSink> sink,
                                Compression compression = Compression::none);

    Status add(const Schema& schema);
    Status add(const Channel& channel);  ///< after its schema, before its messages
    Status add(const Attachment& attachment);
    Status add(const Metadata& metadata);
    Status add(const ChunkBuilder& chunk);

    /// Summary, footer, and the sink's close.
    Status end();

    std::uint64_t size() const { return offset_; }
    const Statistics& statistics() const { return statistics_; }

  private:
    Writer(std::unique_ptr<ByteSink> sink, Compression compression)
        : sink_(std::move(sink)), packer_(compression) {}

    Status put(Bytes bytes);
    Status put_scratch();
    void count(const ChunkBuilder& builder, const Chunk& chunk);
    template <class Records>
    void append_group(Op op, const Records& records);

    std::unique_ptr<ByteSink> sink_;
    ChunkPacker packer_;
    std::uint64_t offset_ = 0;
    std::uint32_t crc_ = 0;  // of all bytes so far
    Buffer scratch_;

    Statistics statistics_;
    std::vector<Schema> schemas_;
    std::vector<Channel> channels_;
    std::vector<ChunkIndex> chunks_;
    std::vector<AttachmentIndex> attachments_;
    std::vector<MetadataIndex> metadata_;
    std::vector<SummaryOffset> groups_;
};

}  // namespace foverig::mcap
