#include "devices/time.h"

#include <thread>

namespace foverig {

WallClock::WallClock(double speed) : start_(std::chrono::steady_clock::now()), speed_(speed) {}

HostTime WallClock::now() const {
    const auto passed =
        std::chrono::duration_cast<Nanoseconds>(std::chrono::steady_clock::now() - start_);
    // Integers stay exact at the usual speed.
    return HostTime(speed_ == 1.0 ? passed : from_seconds(to_seconds(passed) * speed_));
}

void WallClock::sleep_until(HostTime deadline) {
    Nanoseconds wait = deadline.time_since_epoch();
    if (speed_ != 1.0) wait = from_seconds(to_seconds(wait) / speed_);
    std::this_thread::sleep_until(
        start_ + std::chrono::duration_cast<std::chrono::steady_clock::duration>(wait));
}

}  // namespace foverig
