#pragma once
// A recording to replay: what it says of itself, and where its devices' streams lie.
#include <algorithm>
#include <filesystem>
#include <memory>

#include "devices/recording/mcap_summary.h"
#include "devices/time.h"

namespace foverig {

/// Beyond 36 years a time is noise; so sums of two cannot overflow.
inline HostTime recorded_time(std::uint64_t ns) {
    return HostTime(Nanoseconds(static_cast<std::int64_t>(std::min(ns, std::uint64_t{1} << 60))));
}

class Recording {
  public:
    /// One sentence for a file that is absent, torn, damaged or no recording.
    static Result<Recording> open(const std::filesystem::path& file);
    static Result<Recording> open(std::unique_ptr<ByteSource> source, const std::string& name);

    const std::string& name() const { return file_->name(); }
    const mcap::Summary& summary() const { return summary_; }
    const std::shared_ptr<const mcap::RecordFile>& file() const { return file_; }
    /// From the first to the last message.
    HostTime first() const;
    HostTime last() const;
    /// From a message to itself in the next round of a replay that begins again at the end.
    Nanoseconds round() const;

    /// Has packets of this device ("dk2", "gaze").
    bool has(const std::string& device) const;
    /// An attachment's text, or metadata's; not_found where there is none of that name.
    Result<std::string> attachment(const std::string& name) const;
    Result<mcap::Texts> metadata(const std::string& name) const;

  private:
    Recording(mcap::RecordFile file, mcap::Summary summary);

    std::shared_ptr<const mcap::RecordFile> file_;
    mcap::Summary summary_;
};

}  // namespace foverig
