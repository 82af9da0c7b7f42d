#pragma once
// Sinks for tests: bytes that outlive the writer, a disk that is slow or full.
#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>

#include "devices/recording/byte_sink.h"

namespace foverig::test {

/// What was written so far; the writer's thread and the test's may meet here.
class Disk {
  public:
    std::vector<std::byte> bytes() const {
        const std::lock_guard lock(mutex_);
        return bytes_;
    }
    /// Returns once at least `size` bytes are there.
    void wait_for(std::size_t size) {
        std::unique_lock lock(mutex_);
        grown_.wait(lock, [&] { return bytes_.size() >= size; });
    }
    void write(Bytes bytes) {
        const std::lock_guard lock(mutex_);
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
        grown_.notify_all();
    }

  private:
    mutable std::mutex mutex_;
    std::condition_variable grown_;
    std::vector<std::byte> bytes_;
};

class MemorySink final : public ByteSink {
  public:
    /// `before_write` may wait, or fail.
    explicit MemorySink(
        Disk& disk, std::function<Status()> before_write = [] { return Status(Done{}); })
        : disk_(disk), before_write_(std::move(before_write)) {}

    Status write(Bytes bytes) override {
        if (auto status = before_write_(); !status) return status;
        disk_.write(bytes);
        return Done{};
    }
    Status close() override { return Done{}; }

  private:
    Disk& disk_;
    std::function<Status()> before_write_;
};

}  // namespace foverig::test
