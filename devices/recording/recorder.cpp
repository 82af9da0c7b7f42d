#include "devices/recording/recorder.h"

#include <algorithm>

namespace foverig {
namespace {

/// MCAP has no times before 0: a device's clock may be mapped a little before the run's start.
std::uint64_t file_time_ns(HostTime time) {
    return static_cast<std::uint64_t>(std::max<std::int64_t>(0, time.time_since_epoch().count()));
}

}  // namespace

Result<std::unique_ptr<Recorder>> Recorder::begin(std::unique_ptr<ByteSink> sink,
                                                  const RecorderConfig& config) {
    auto writer = mcap::Writer::begin(std::move(sink), config.compression);
    if (!writer) return writer.error();
    return std::unique_ptr<Recorder>(new Recorder(std::move(writer).value(), config));
}

Recorder::Recorder(mcap::Writer writer, const RecorderConfig& config)
    : config_(config), writer_(std::move(writer)), thread_([this] { write_jobs(); }) {}

Recorder::~Recorder() {
    if (thread_.joinable()) (void)close();
}

Recorder::TopicId Recorder::add_topic(const RecordedTopic& topic) {
    const std::lock_guard lock(mutex_);
    const auto id = static_cast<TopicId>(topics_.size());
    topics_.push_back({.name = topic.topic});
    mcap::Channel channel{.id = id,
                          .schema_id = 0,
                          .topic = topic.topic,
                          .message_encoding = topic.message_encoding,
                          .metadata = topic.metadata};
    if (!topic.schema_name.empty()) {
        channel.schema_id = static_cast<std::uint16_t>(id + 1);
        queue_.emplace_back(mcap::Schema{.id = channel.schema_id,
                                         .name = topic.schema_name,
                                         .encoding = "jsonschema",
                                         .data = topic.json_schema});
    }
    queue_.emplace_back(std::move(channel));
    work_.notify_one();
    return id;
}

bool Recorder::make_room(std::unique_lock<std::mutex>& lock, std::size_t size) {
    const auto has_room = [&] {
        const std::size_t held = queued_bytes_ + open_.size();
        return held == 0 || held + size <= config_.queue_bytes || error_;
    };
    if (!has_room() && config_.wait_when_full) {
        push_open_chunk();
        room_.wait(lock, has_room);
    }
    return has_room() && !error_;
}

void Recorder::record(TopicId topic, HostTime log, HostTime publish, Bytes data) {
    std::unique_lock lock(mutex_);
    const std::uint32_t sequence = topics_[topic].sequence++;
    if (!make_room(lock, mcap::kMessageHead + data.size())) {
        ++topics_[topic].dropped;
        ++counts_.dropped;
        return;
    }
    ++counts_.messages;
    open_.add({.channel = topic,
               .sequence = sequence,
               .log_time_ns = file_time_ns(log),
               .publish_time_ns = file_time_ns(publish),
               .data = data});
    if (open_.size() >= config_.chunk_bytes) push_open_chunk();
}

void Recorder::attach(mcap::Attachment attachment) {
    const std::lock_guard lock(mutex_);
    queue_.emplace_back(std::move(attachment));
    work_.notify_one();
}

void Recorder::note(mcap::Metadata metadata) {
    const std::lock_guard lock(mutex_);
    queue_.emplace_back(std::move(metadata));
    work_.notify_one();
}

void Recorder::push_open_chunk() {
    if (open_.empty()) return;
    queued_bytes_ += open_.size();
    queue_.emplace_back(std::move(open_));
    open_ = mcap::ChunkBuilder();
    if (!spare_.empty()) {
        open_ = std::move(spare_.back());
        spare_.pop_back();
    }
    work_.notify_one();
}

void Recorder::write_jobs() {
    std::unique_lock lock(mutex_);
    const WallClock clock;
    HostTime next_flush = clock.now() + config_.flush_period;
    while (true) {
        work_.wait_for(lock, next_flush - clock.now(), [&] { return closing_ || !queue_.empty(); });
        if (closing_ || clock.now() >= next_flush) {
            push_open_chunk();
            next_flush = clock.now() + config_.flush_period;
        }
        if (queue_.empty() && closing_) return;
        if (queue_.empty()) continue;

        Job job = std::move(queue_.front());
        queue_.pop_front();
        const bool broken = error_.has_value();
        lock.unlock();
        const Status status = broken ? Status(Done{}) : write(job);
        lock.lock();
        if (!status) error_ = status.error();
        if (auto* chunk = std::get_if<mcap::ChunkBuilder>(&job)) {
            queued_bytes_ -= chunk->size();
            chunk->clear();
            spare_.push_back(std::move(*chunk));
        }
        room_.notify_all();
    }
}

Status Recorder::write(const Job& job) {
    return std::visit([this](const auto& record) { return writer_.add(record); }, job);
}

RecorderCounts Recorder::counts() const {
    const std::lock_guard lock(mutex_);
    RecorderCounts counts = counts_;
    for (const Topic& topic : topics_) {
        if (topic.dropped > 0) counts.dropped_of[topic.name] = topic.dropped;
    }
    return counts;
}

Status Recorder::status() const {
    const std::lock_guard lock(mutex_);
    return error_ ? Status(*error_) : Status(Done{});
}

mcap::Metadata Recorder::closing_note() const {
    const RecorderCounts all = counts();
    mcap::Metadata note{.name = "foverig.recorder", .texts = {}};
    note.texts["messages"] = std::to_string(all.messages);
    note.texts["dropped"] = std::to_string(all.dropped);
    for (const auto& [topic, dropped] : all.dropped_of) {
        note.texts["dropped " + topic] = std::to_string(dropped);
    }
    return note;
}

Status Recorder::close() {
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
    }
    work_.notify_one();
    if (!thread_.joinable()) return status();
    thread_.join();
    if (auto failed = status(); !failed) return failed;
    Status ended = writer_.add(closing_note());
    if (ended) ended = writer_.end();
    const std::lock_guard lock(mutex_);
    if (!ended) error_ = ended.error();
    counts_.bytes = writer_.size();
    return ended;
}

}  // namespace foverig
