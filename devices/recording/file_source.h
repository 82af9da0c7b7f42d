#pragma once
#include <filesystem>

#include "devices/recording/byte_source.h"

namespace foverig {

/// A regular file, as large as it was when it was opened.
class FileSource final : public ByteSource {
  public:
    static Result<FileSource> open(const std::filesystem::path& file);
    FileSource(FileSource&& other) noexcept;
    FileSource& operator=(FileSource&&) = delete;
    ~FileSource() override;

    std::uint64_t size() const override { return size_; }
    Status read(std::uint64_t offset, std::span<std::byte> out) const override;

  private:
    FileSource(std::filesystem::path file, int descriptor, std::uint64_t size);

    std::filesystem::path file_;
    int descriptor_;  // -1: moved away
    std::uint64_t size_;
};

}  // namespace foverig
