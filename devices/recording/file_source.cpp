#include "devices/recording/file_source.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace foverig {

Result<FileSource> FileSource::open(const std::filesystem::path& file) {
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) {
        return Error{ErrorCode::not_found,
                     fmt::format("{}: cannot be opened: {}", file.string(), std::strerror(errno))};
    }
    FileSource source(file, descriptor, 0);
    struct stat about {};
    if (::fstat(descriptor, &about) != 0 || !S_ISREG(about.st_mode)) {
        return Error{ErrorCode::invalid_data,
                     fmt::format("{}: is no file; expected a recording (MCAP)", file.string())};
    }
    source.size_ = static_cast<std::uint64_t>(about.st_size);
    return source;
}

FileSource::FileSource(std::filesystem::path file, int descriptor, std::uint64_t size)
    : file_(std::move(file)), descriptor_(descriptor), size_(size) {}

FileSource::FileSource(FileSource&& other) noexcept
    : file_(std::move(other.file_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_) {}

FileSource::~FileSource() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

Status FileSource::read(std::uint64_t offset, std::span<std::byte> out) const {
    while (!out.empty()) {
        const ssize_t got =
            ::pread(descriptor_, out.data(), out.size(), static_cast<off_t>(offset));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) {
            const std::string why = got == 0 ? "it became shorter" : std::strerror(errno);
            return Error{ErrorCode::io, fmt::format("{}: cannot be read: {}", file_.string(), why)};
        }
        out = out.subspan(static_cast<std::size_t>(got));
        offset += static_cast<std::uint64_t>(got);
    }
    return Done{};
}

}  // namespace foverig
