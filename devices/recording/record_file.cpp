#include "devices/recording/record_file.h"

#include <fmt/format.h>

namespace foverig::mcap {

Result<RecordFile> RecordFile::open(std::unique_ptr<ByteSource> source, std::string name) {
    std::array<std::byte, kMagic.size()> magic{};
    RecordFile file(std::move(source), std::move(name));
    if (file.size() >= magic.size()) {
        if (auto status = file.source_->read(0, magic); !status) return status.error();
    }
    if (magic != kMagic) {
        return Error{ErrorCode::invalid_data,
                     fmt::format("{}: is no recording; expected an MCAP file, as foverig record "
                                 "makes them",
                                 file.name_)};
    }
    return file;
}

Result<RecordPlace> RecordFile::place(std::uint64_t offset) const {
    std::array<std::byte, kRecordHead> head{};
    if (offset > size() || size() - offset < head.size()) {
        return damaged(offset, "the file ends in the middle of a record");
    }
    if (auto status = source_->read(offset, head); !status) return status.error();
    const RecordPlace place{static_cast<Op>(read_u8(head, 0)), offset, read_u64(head, 1)};
    if (place.content_size > size() - offset - kRecordHead) {
        return damaged(offset, "a record goes beyond the end of the file");
    }
    return place;
}

Result<Bytes> RecordFile::bytes(std::uint64_t offset, std::uint64_t size,
                                std::vector<std::byte>& buffer) const {
    if (size > kLargestRecord) {
        return damaged(offset, fmt::format("a record is larger than {} MB", kLargestRecord >> 20));
    }
    if (buffer.size() < size) buffer.resize(static_cast<std::size_t>(size));
    const auto filled = std::span(buffer).first(static_cast<std::size_t>(size));
    if (auto status = source_->read(offset, filled); !status) return status.error();
    return Bytes(filled);
}

Result<Bytes> RecordFile::content(const RecordPlace& place, std::vector<std::byte>& buffer) const {
    return bytes(place.content(), place.content_size, buffer);
}

Error RecordFile::damaged(std::uint64_t offset, const std::string& what) const {
    return {ErrorCode::invalid_data,
            fmt::format("{}: damaged at byte {}: {}; foverig recover saves what can be saved",
                        name_, offset, what)};
}

}  // namespace foverig::mcap
