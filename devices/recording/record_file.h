#pragma once
// Records of a file, read one by one, with every length checked against the file's before memory is
// asked for.
#include <memory>
#include <optional>

#include "devices/recording/byte_source.h"
#include "devices/recording/mcap_decode.h"

namespace foverig::mcap {

/// A larger record is refused: nothing that we or others write comes near it.
constexpr std::uint64_t kLargestRecord = std::uint64_t{256} << 20;

struct RecordPlace {
    Op op{};
    std::uint64_t offset = 0;  ///< of the opcode
    std::uint64_t content_size = 0;
    std::uint64_t content() const { return offset + kRecordHead; }
    std::uint64_t end() const { return content() + content_size; }
};

class RecordFile {
  public:
    /// `name` is what complaints begin with. Refuses what does not begin as MCAP does.
    static Result<RecordFile> open(std::unique_ptr<ByteSource> source, std::string name);

    const std::string& name() const { return name_; }
    std::uint64_t size() const { return source_->size(); }

    /// The record that begins at `offset`; an error where it does not fit into the file.
    Result<RecordPlace> place(std::uint64_t offset) const;
    /// `size` bytes from `offset` on, into a buffer that is used again.
    Result<Bytes> bytes(std::uint64_t offset, std::uint64_t size,
                        std::vector<std::byte>& buffer) const;
    /// A record's content, and its decoded form, which owns what it holds.
    Result<Bytes> content(const RecordPlace& place, std::vector<std::byte>& buffer) const;
    template <class T>
    Result<T> decoded(std::uint64_t offset, Op op, Result<T> (*decode)(Bytes)) const;

    Error damaged(std::uint64_t offset, const std::string& what) const;

  private:
    RecordFile(std::unique_ptr<ByteSource> source, std::string name)
        : source_(std::move(source)), name_(std::move(name)) {}

    std::unique_ptr<ByteSource> source_;
    std::string name_;
};

template <class T>
Result<T> RecordFile::decoded(std::uint64_t offset, Op op, Result<T> (*decode)(Bytes)) const {
    const auto where = place(offset);
    if (!where) return where.error();
    if (where->op != op) return damaged(offset, "another record stands there than its index says");
    std::vector<std::byte> buffer;
    const auto bytes = content(*where, buffer);
    if (!bytes) return bytes.error();
    auto value = decode(*bytes);
    if (!value) return damaged(offset, value.error().text);
    return value;
}

}  // namespace foverig::mcap
