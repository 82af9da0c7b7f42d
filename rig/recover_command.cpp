#include <fmt/format.h>
#include <unistd.h>

#include <stdexcept>

#include "devices/recording/file_sink.h"
#include "devices/recording/file_source.h"
#include "devices/recording/recover.h"
#include "rig/commands.h"

namespace foverig {
namespace fs = std::filesystem;
namespace {

mcap::RecordFile opened(const fs::path& file) {
    auto source = FileSource::open(file);
    if (!source) throw InputError(source.error().text);
    auto opened = mcap::RecordFile::open(std::make_unique<FileSource>(std::move(source).value()),
                                         file.string());
    if (!opened) throw InputError(opened.error().text);
    return std::move(opened).value();
}

/// A file that goes away unless it is kept: mending is whole or not at all.
class Draft {
  public:
    explicit Draft(const fs::path& place) : place_(place), draft_(place) {
        draft_ += fmt::format(".draft-{}", getpid());
    }
    ~Draft() {
        std::error_code ignored;  // a destructor has nobody to tell
        fs::remove(draft_, ignored);
    }
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;

    const fs::path& path() const { return draft_; }
    void keep() const { fs::rename(draft_, place_); }

  private:
    fs::path place_, draft_;
};

double seconds_of(const mcap::Recovery& r) {
    return static_cast<double>(r.end_ns - r.start_ns) * 1e-9;
}

}  // namespace

ExitCode recover_command(const fs::path& file, const std::optional<fs::path>& out) {
    const auto torn = opened(file);
    fs::path place = out.value_or(fs::path(file).replace_extension(".recovered.mcap"));
    if (fs::exists(place)) {
        throw UsageError(
            fmt::format("{}: is there already; name another file with --out", place.string()));
    }
    const Draft draft(place);
    auto sink = FileSink::create(draft.path());
    if (!sink) throw UsageError("--out " + sink.error().text);
    const auto recovery = mcap::recover(torn, std::make_unique<FileSink>(std::move(sink).value()));
    if (!recovery && recovery.error().code == ErrorCode::io) {
        throw std::runtime_error(recovery.error().text);
    }
    if (!recovery) throw InputError(recovery.error().text);
    if (recovery->was_whole) {
        fmt::print("{}: is whole: {} messages over {:.3f} s; nothing to mend\n", file.string(),
                   recovery->messages, seconds_of(*recovery));
        return ExitCode::good;
    }
    if (auto status = mcap::check_recovered(opened(draft.path()), *recovery); !status) {
        throw std::runtime_error(status.error().text);
    }
    if (recovery->messages == 0) {
        throw InputError(
            fmt::format("{}: none of its messages can be read, so there is nothing to "
                        "save",
                        file.string()));
    }
    draft.keep();
    fmt::print("saved {} messages over {:.3f} s, {} attachments, {} metadata records: {}\n",
               recovery->messages, seconds_of(*recovery), recovery->attachments, recovery->metadata,
               place.string());
    if (recovery->losses.empty()) fmt::print("lost  nothing but the index, which was made again\n");
    for (const std::string& loss : recovery->losses) fmt::print("lost  {}\n", loss);
    if (!recovery->had_end) {
        fmt::print(
            "The file has no end: what the recorder still held when it died (a second at most) "
            "is not in it.\n");
    }
    return ExitCode::good;
}

}  // namespace foverig
