#pragma once
// Messages into an MCAP file without holding up who records them: they are put into the open chunk,
// and one thread writes chunks. What the queue cannot hold is counted as dropped, never lost
// silently, and a sequence number is skipped for it.
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <variant>

#include "devices/recording/mcap_writer.h"
#include "devices/time.h"

namespace foverig {

struct RecorderConfig {
    std::size_t chunk_bytes = std::size_t{1} << 20;   ///< a chunk of this size is written
    std::size_t queue_bytes = std::size_t{64} << 20;  ///< held while the disk is slower
    /// A chunk is written after this long, full or not: what a crash can cost, besides a stall of
    /// the disk. Real time, whatever the run's clock does.
    Nanoseconds flush_period{250'000'000};
    mcap::Compression compression = mcap::Compression::none;
    bool wait_when_full = false;  ///< where time can wait (lockstep): wait instead of dropping
};

/// What is recorded under one topic.
struct RecordedTopic {
    std::string topic;
    std::string message_encoding;  ///< "json", "x-hid", ...
    std::string schema_name{};     ///< empty: no schema
    std::string json_schema{};
    mcap::Texts metadata{};
};

struct RecorderCounts {
    std::uint64_t messages = 0;  ///< taken
    std::uint64_t dropped = 0;
    std::uint64_t bytes = 0;                          ///< of the file, once it is closed
    std::map<std::string, std::uint64_t> dropped_of;  ///< only topics that dropped
};

class Recorder {
  public:
    using TopicId = std::uint16_t;

    static Result<std::unique_ptr<Recorder>> begin(std::unique_ptr<ByteSink> sink,
                                                   const RecorderConfig& config = {});
    /// Closes; who wants to know of an error calls `close`.
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// Any thread may call these. None waits for the disk unless `wait_when_full`.
    TopicId add_topic(const RecordedTopic& topic);
    void record(TopicId topic, HostTime log, HostTime publish, Bytes data);
    void attach(mcap::Attachment attachment);
    void note(mcap::Metadata metadata);

    RecorderCounts counts() const;
    /// The first error of writing, if there was one.
    Status status() const;
    /// Writes all that is queued, the counts as metadata "foverig.recorder", and the index.
    Status close();

  private:
    using Job = std::variant<mcap::ChunkBuilder, mcap::Schema, mcap::Channel, mcap::Attachment,
                             mcap::Metadata>;
    struct Topic {
        std::string name;
        std::uint32_t sequence = 0;
        std::uint64_t dropped = 0;
    };

    Recorder(mcap::Writer writer, const RecorderConfig& config);
    void write_jobs();
    Status write(const Job& job);
    void push_open_chunk();
    bool make_room(std::unique_lock<std::mutex>& lock, std::size_t size);
    mcap::Metadata closing_note() const;

    RecorderConfig config_;
    mcap::Writer writer_;  // the thread's alone until it is joined

    mutable std::mutex mutex_;  // guards what follows
    std::condition_variable work_, room_;
    mcap::ChunkBuilder open_;
    std::deque<Job> queue_;
    std::vector<mcap::ChunkBuilder> spare_;
    std::size_t queued_bytes_ = 0;  // of chunks in the queue and in writing
    std::vector<Topic> topics_;
    RecorderCounts counts_;
    std::optional<Error> error_;
    bool closing_ = false;

    std::thread thread_;
};

}  // namespace foverig
