#include "devices/time.h"

#include <thread>

namespace foverig {

WallClock::WallClock() : start_(std::chrono::steady_clock::now()) {}

HostTime WallClock::now() const {
    return HostTime(
        std::chrono::duration_cast<Nanoseconds>(std::chrono::steady_clock::now() - start_));
}

void WallClock::sleep_until(HostTime deadline) {
    std::this_thread::sleep_until(start_ +
                                  std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                      deadline.time_since_epoch()));
}

}  // namespace foverig
