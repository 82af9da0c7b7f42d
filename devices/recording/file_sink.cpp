#include "devices/recording/file_sink.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace foverig {

Result<FileSink> FileSink::create(const std::filesystem::path& file) {
    int descriptor = -1;
    do {
        descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    } while (descriptor < 0 && errno == EINTR);
    FileSink sink(file, descriptor);
    if (descriptor < 0) return sink.failure("cannot be made");
    return sink;
}

FileSink::FileSink(std::filesystem::path file, int descriptor)
    : file_(std::move(file)), descriptor_(descriptor) {}

FileSink::FileSink(FileSink&& other) noexcept
    : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

FileSink::~FileSink() {
    if (descriptor_ >= 0) ::close(descriptor_);  // who wants to know of an error has called close
}

Status FileSink::write(Bytes bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return failure("cannot be written");
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return Done{};
}

Status FileSink::close() {
    // Not again on EINTR: on Linux the descriptor is gone either way.
    if (::close(std::exchange(descriptor_, -1)) != 0 && errno != EINTR) {
        return failure("cannot be written");
    }
    return Done{};
}

Error FileSink::failure(const char* what) const {
    return {ErrorCode::io, fmt::format("{}: {}: {}; make room or choose another place",
                                       file_.string(), what, std::strerror(errno))};
}

}  // namespace foverig
