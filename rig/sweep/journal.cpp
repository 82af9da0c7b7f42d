#include "rig/sweep/journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

#include "rig/failure.h"

namespace foverig::sweep {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

constexpr const char* kSchema = "foverig.sweep/1";

std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (!stream || (stream.peek() != EOF && !(text << stream.rdbuf())))
        throw InputError(
            fmt::format("{}: cannot be read; expected what `foverig sweep` wrote", file.string()));
    return text.str();
}

/// False where the line is none of ours.
bool take(std::string_view text, JournalContent& content) {
    try {
        const json line = json::parse(text);
        if (content.header.is_null()) {
            content.header = line;
            return line.at("schema") == kSchema;
        }
        if (line.at("kind") == "accuracy")
            content.accuracies.push_back(accuracy_from(line));
        else
            content.times.push_back(times_from(line));
        return true;
    } catch (const json::exception&) {
        return false;
    }
}

}  // namespace

fs::path journal_name(const Shard& shard) {
    return shard.count == 1 ? "runs.jsonl"
                            : fmt::format("runs-{}-of-{}.jsonl", shard.index, shard.count);
}

bool JournalContent::has(const Job& job) const {
    if (job.repetition < 0)
        return std::any_of(accuracies.begin(), accuracies.end(),
                           [&](const Accuracy& a) { return a.point == job.point; });
    return std::any_of(times.begin(), times.end(), [&](const Times& t) {
        return t.point == job.point && t.repetition == job.repetition;
    });
}

JournalContent read_journal(const fs::path& file) {
    const std::string text = text_of(file);
    JournalContent content;
    int number = 0;
    for (std::size_t begin = 0, end = 0; (end = text.find('\n', begin)) != std::string::npos;
         begin = end + 1) {
        ++number;
        if (!take(std::string_view(text).substr(begin, end - begin), content))
            throw InputError(
                fmt::format("{}:{}: not a line that `foverig sweep` wrote; expected the file as it "
                            "was left, so "
                            "delete it to measure all of it again",
                            file.string(), number));
        content.whole_bytes = end + 1;
    }
    return content;
}

Journal::Journal(const fs::path& file)
    : file_(file),
      descriptor_(open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0) fail(errno);
    try {
        if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
            throw UsageError(fmt::format(
                "{}: another process is at work on it; expected one a shard", file.string()));
        content_ = read_journal(file);
        if (ftruncate(descriptor_, static_cast<off_t>(content_.whole_bytes)) != 0) fail(errno);
    } catch (...) {
        close(descriptor_);
        throw;
    }
}

Journal::~Journal() {
    close(descriptor_);
}

void Journal::append(const json& line) {
    const std::string text = line.dump() + "\n";
    std::size_t written = 0;
    while (written < text.size()) {
        const ssize_t n = write(descriptor_, text.data() + written, text.size() - written);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) break;
        written += static_cast<std::size_t>(n);
    }
    if (written < text.size() || fdatasync(descriptor_) != 0) fail(errno);
}

void Journal::fail(int error) const {
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", file_.string(),
                                         std::generic_category().message(error)));
}

}  // namespace foverig::sweep
