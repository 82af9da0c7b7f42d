#pragma once
#include <filesystem>

#include "devices/recording/byte_sink.h"

namespace foverig {

/// A new file. What `write` has returned from survives the program's death (not the machine's).
class FileSink final : public ByteSink {
  public:
    /// An existing file is replaced.
    static Result<FileSink> create(const std::filesystem::path& file);
    FileSink(FileSink&& other) noexcept;
    FileSink& operator=(FileSink&&) = delete;
    ~FileSink() override;

    Status write(Bytes bytes) override;
    Status close() override;

  private:
    FileSink(std::filesystem::path file, int descriptor);
    Error failure(const char* what) const;

    std::filesystem::path file_;
    int descriptor_;  // -1: closed
};

}  // namespace foverig
