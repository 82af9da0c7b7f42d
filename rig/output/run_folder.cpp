#include "rig/output/run_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "rig/failure.h"

namespace foverig {
namespace fs = std::filesystem;
namespace {

fs::path next_free() {
    for (int i = 1;; ++i) {
        fs::path place = fs::path("runs") / fmt::format("{:03}", i);
        if (!fs::exists(place)) return place;
    }
}

void check_replaceable(const fs::path& place) {
    if (!fs::exists(place)) return;
    if (!fs::is_directory(place)) {
        throw UsageError(fmt::format("--out {}: is a file; expected a folder", place.string()));
    }
    if (!fs::is_empty(place) && !fs::exists(place / "summary.json")) {
        throw UsageError(fmt::format(
            "--out {}: holds files that are no run; expected a new, an empty or a run folder",
            place.string()));
    }
}

/// Beside the place, so that renaming stays within one file system.
fs::path beside(const fs::path& place, const char* suffix) {
    fs::path other = place;
    other += fmt::format(".{}-{}", suffix, getpid());
    return other;
}

/// A std::runtime_error that knows why.
std::system_error not_written(const fs::path& file, std::error_code why) {
    return {why, fmt::format("{}: cannot be written", file.string())};
}

/// `called`: what an error names.
void write_as(const fs::path& file, std::string_view text, const fs::path& called) {
    errno = 0;
    std::ofstream stream(file, std::ios::binary);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream) throw not_written(called, std::error_code(errno, std::generic_category()));
}

/// Where a text may be written beside and renamed to: behind a link, which stays, is a file, or
/// nothing is there. Else nullopt.
std::optional<fs::path> replaceable(const fs::path& file) {
    std::error_code error;
    const bool is_link = fs::is_symlink(file, error);
    const fs::file_status status = fs::status(file, error);
    if (fs::is_regular_file(status)) return is_link ? fs::canonical(file) : file;
    if (is_link || fs::exists(status)) return std::nullopt;
    return file;
}

}  // namespace

RunFolder::RunFolder(const std::optional<fs::path>& out)
    : place_(out ? (*out / "").parent_path() : next_free()), draft_(beside(place_, "draft")) {
    check_replaceable(place_);
    std::error_code error;
    fs::create_directories(draft_, error);
    if (error) {
        throw UsageError(
            fmt::format("--out {}: cannot be written: {}; expected a folder that may "
                        "be made",
                        place_.string(), error.message()));
    }
}

RunFolder::~RunFolder() {
    std::error_code ignored;  // a destructor has nobody to tell
    fs::remove_all(draft_, ignored);
}

void RunFolder::write(const fs::path& name, std::string_view text) const {
    write_text(draft_ / name, text);
}

std::optional<fs::path> RunFolder::rescue(const fs::path& name) const noexcept {
    std::error_code error;
    fs::path kept = beside(place_, "failed") += name.extension();
    for (int i = 2; fs::exists(kept, error);
         ++i) {  // of an older run, whose process had the number
        kept = beside(place_, "failed") += fmt::format("-{}{}", i, name.extension().string());
    }
    fs::rename(draft_ / name, kept, error);
    if (error) return std::nullopt;
    return kept;
}

void RunFolder::publish() {
    const fs::path old = beside(place_, "old");
    if (fs::exists(place_)) fs::rename(place_, old);
    fs::rename(draft_, place_);
    fs::remove_all(old);
}

void write_text(const fs::path& file, std::string_view text) {
    write_as(file, text, file);
}

void replace_text(const fs::path& file, std::string_view text) {
    const auto place = replaceable(file);
    if (!place) return write_text(file, text);
    const fs::path draft = beside(*place, "draft");
    try {
        write_as(draft, text, file);
        std::error_code error;
        fs::rename(draft, *place, error);
        if (error) throw not_written(file, error);
    } catch (...) {
        std::error_code ignored;  // the first error is the one to tell
        fs::remove(draft, ignored);
        throw;
    }
}

}  // namespace foverig
