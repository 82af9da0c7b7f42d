#include "simulators/replay/recording.h"

#include <fmt/format.h>

#include "devices/recording/device_topics.h"
#include "devices/recording/file_source.h"

namespace foverig {
namespace {

constexpr Nanoseconds kLoopPause{1'000'000};  // between the last message and the first one again

Error absent(const std::string& file, const std::string& what) {
    return {ErrorCode::not_found, fmt::format("{}: has no {}; expected a recording of foverig's "
                                              "own (foverig record, recording.enabled = true)",
                                              file, what)};
}

}  // namespace

Result<Recording> Recording::open(const std::filesystem::path& file) {
    auto source = FileSource::open(file);
    if (!source) return source.error();
    return open(std::make_unique<FileSource>(std::move(source).value()), file.string());
}

Result<Recording> Recording::open(std::unique_ptr<ByteSource> source, const std::string& name) {
    auto file = mcap::RecordFile::open(std::move(source), name);
    if (!file) return file.error();
    auto summary = mcap::read_summary(*file);
    if (!summary) return summary.error();
    return Recording(std::move(file).value(), std::move(summary).value());
}

Recording::Recording(mcap::RecordFile file, mcap::Summary summary)
    : file_(std::make_shared<const mcap::RecordFile>(std::move(file))),
      summary_(std::move(summary)) {}

HostTime Recording::first() const {
    return recorded_time(summary_.statistics ? summary_.statistics->start_ns : 0);
}

HostTime Recording::last() const {
    return recorded_time(summary_.statistics ? summary_.statistics->end_ns : 0);
}

Nanoseconds Recording::round() const {
    return last() - first() + kLoopPause;
}

bool Recording::has(const std::string& device) const {
    return summary_.channel(raw_topic(device)) != nullptr;
}

Result<std::string> Recording::attachment(const std::string& wanted) const {
    for (const mcap::AttachmentIndex& index : summary_.attachments) {
        if (index.name != wanted) continue;
        const auto found =
            file_->decoded(index.offset, mcap::Op::attachment, mcap::decode_attachment);
        if (!found) return found.error();
        return std::string(reinterpret_cast<const char*>(found->data.data()), found->data.size());
    }
    return absent(name(), wanted);
}

Result<mcap::Texts> Recording::metadata(const std::string& wanted) const {
    for (const mcap::MetadataIndex& index : summary_.metadata) {
        if (index.name != wanted) continue;
        const auto found = file_->decoded(index.offset, mcap::Op::metadata, mcap::decode_metadata);
        if (!found) return found.error();
        return found->texts;
    }
    return absent(name(), wanted);
}

}  // namespace foverig
