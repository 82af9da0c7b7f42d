#include "rig/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace foverig {
namespace {

constexpr Nanoseconds kRewriteEvery{100'000'000};
constexpr Nanoseconds kLineEvery{5'000'000'000};

}  // namespace

Progress::Progress() : on_terminal_(isatty(STDERR_FILENO) == 1) {}

void Progress::show(const SessionProgress& progress) {
    if (clock_.now() < next_ && progress.share < 1.0) return;
    put(fmt::format("frame {}  {:3.0f} %  {:.1f} ms a frame", progress.frames,
                    100.0 * progress.share, progress.frame_time_ms));
}

void Progress::show(HostTime until, const RecorderCounts& counts) {
    if (clock_.now() < next_) return;
    put(fmt::format("recorded {:.3f} s  {} messages  {} dropped",
                    to_seconds(until.time_since_epoch()), counts.messages, counts.dropped));
}

void Progress::put(const std::string& line) {
    next_ = clock_.now() + (on_terminal_ ? kRewriteEvery : kLineEvery);
    if (on_terminal_) {
        fmt::print(stderr, "\r\x1b[2K{}", line);
        line_open_ = true;
    } else {
        fmt::print(stderr, "{}\n", line);
    }
    std::fflush(stderr);
}

void Progress::say(const std::string& text) {
    fmt::print(stderr, "{}{}\n", line_open_ ? "\r\x1b[2K" : "", text);
    std::fflush(stderr);
    line_open_ = false;
}

void Progress::done() {
    if (line_open_) fmt::print(stderr, "\n");
    line_open_ = false;
}

}  // namespace foverig
