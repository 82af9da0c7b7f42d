#pragma once
// The kernel as a camera driver sees it: the few system calls of V4L2, so that their order and
// their failures can be tested without a kernel device (mmap cannot be emulated in front of one).
#include <cstddef>
#include <cstdint>
#include <memory>

namespace foverig::hardware {

/// Each returns what the system call does: -1 and errno where it failed.
class VideoCalls {
  public:
    virtual ~VideoCalls() = default;
    virtual int open(const char* path) = 0;  ///< to read and write, without waiting
    virtual int close(int file) = 0;
    virtual int ioctl(int file, unsigned long request, void* argument) = 0;  ///< again after EINTR
    virtual void* map(std::size_t size, int file, std::int64_t offset) = 0;  ///< MAP_FAILED
    virtual int unmap(void* memory, std::size_t size) = 0;
    /// Waits for a buffer: above 0 there is one, 0 none in time.
    virtual int wait(int file, int timeout_ms) = 0;
    virtual void pause(int ms) = 0;
    virtual std::int64_t monotonic_ns() = 0;
};

/// The real ones.
std::shared_ptr<VideoCalls> kernel_video();

}  // namespace foverig::hardware
