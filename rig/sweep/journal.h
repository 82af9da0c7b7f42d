#pragma once
// What a process has measured so far, on disk before it goes on: a file of JSON lines, the first
// the header. A kill loses the run in work and nothing else.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "rig/sweep/jobs.h"
#include "rig/sweep/records.h"

namespace foverig::sweep {

/// runs.jsonl, or runs-1-of-4.jsonl.
std::filesystem::path journal_name(const Shard& shard);

struct JournalContent {
    nlohmann::json header;
    std::vector<Accuracy> accuracies;
    std::vector<Times> times;
    std::uintmax_t whole_bytes = 0;  ///< of the lines that end; what follows was torn by a kill

    bool has(const Job& job) const;
};

/// Throws InputError with file and line for a line that is not what it should be; a last one
/// without its end is left out. A file whose header is torn has a null header.
JournalContent read_journal(const std::filesystem::path& file);

/// A file that lines are added to, by one process at a time.
class Journal {
  public:
    /// Opens or begins it; what a kill tore is cut off. Throws UsageError where another process has
    /// it open, std::runtime_error where it cannot be written, and as read_journal.
    explicit Journal(const std::filesystem::path& file);
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    /// What was there when it was opened; the header is null where it was not begun.
    const JournalContent& content() const { return content_; }
    /// Returns once the line is on disk. Throws std::runtime_error.
    void append(const nlohmann::json& line);

  private:
    [[noreturn]] void fail(int error) const;

    std::filesystem::path file_;
    int descriptor_;
    JournalContent content_;
};

}  // namespace foverig::sweep
