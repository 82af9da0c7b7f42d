#include "devices/hardware/video_calls.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>

namespace foverig::hardware {
namespace {

class KernelVideo final : public VideoCalls {
  public:
    int open(const char* path) override {
        return ::open(path, O_RDWR | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    }
    int close(int file) override { return ::close(file); }
    int ioctl(int file, unsigned long request, void* argument) override {
        int result = 0;
        do {
            result = ::ioctl(file, request, argument);
        } while (result < 0 && errno == EINTR);
        return result;
    }
    void* map(std::size_t size, int file, std::int64_t offset) override {
        return ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file, offset);
    }
    int unmap(void* memory, std::size_t size) override { return ::munmap(memory, size); }
    int wait(int file, int timeout_ms) override {
        pollfd waited{.fd = file, .events = POLLIN, .revents = 0};
        const int ready = ::poll(&waited, 1, timeout_ms);
        return ready < 0 && errno == EINTR ? 0 : ready;
    }
    void pause(int ms) override { (void)::poll(nullptr, 0, ms); }
    std::int64_t monotonic_ns() override {
        timespec now{};
        (void)::clock_gettime(CLOCK_MONOTONIC, &now);
        return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
    }
};

}  // namespace

std::shared_ptr<VideoCalls> kernel_video() {
    return std::make_shared<KernelVideo>();
}

}  // namespace foverig::hardware
