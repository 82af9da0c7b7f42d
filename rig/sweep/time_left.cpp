#include "rig/sweep/time_left.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace foverig::sweep {
namespace {

constexpr Nanoseconds kLineEvery{5'000'000'000};

std::string duration_text(double seconds) {
    const auto whole = static_cast<long>(std::ceil(seconds));
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace

TimeLeft::TimeLeft(const std::vector<Job>& jobs) : on_terminal_(isatty(STDERR_FILENO) == 1) {
    for (const Job& job : jobs) ++kind_of(job).left;
}

TimeLeft::~TimeLeft() {
    if (on_terminal_) std::fputs("\r\x1b[2K", stderr);
}

void TimeLeft::note(const std::string& what) {
    show(what, false);
    began_ = clock_.now();  // not on the run's time
}

void TimeLeft::tell(const std::string& line) {
    fmt::print(stderr, "{}{}\n", on_terminal_ ? "\r\x1b[2K" : "", line);
}

void TimeLeft::begin(const Job& job) {
    began_ = clock_.now();
    const std::size_t done = kinds_[0].done + kinds_[1].done;
    const std::size_t all = done + kinds_[0].left + kinds_[1].left;
    const std::string left =
        done == 0 ? "" : fmt::format(", about {} left", duration_text(seconds_left()));
    show(fmt::format("run {} of {}: {} of point {}{}", done + 1, all,
                     job.repetition < 0 ? "accuracy" : "time", job.point, left),
         done == 0);
}

void TimeLeft::done(const Job& job) {
    Kind& kind = kind_of(job);
    --kind.left;
    ++kind.done;
    kind.seconds += to_seconds(clock_.now() - began_);
}

double TimeLeft::seconds_left() const {
    // A kind that has not run yet is taken for the other.
    const auto mean = [](const Kind& kind, const Kind& other) {
        const Kind& known = kind.done > 0 ? kind : other;
        return known.seconds / static_cast<double>(known.done);
    };
    return static_cast<double>(kinds_[0].left) * mean(kinds_[0], kinds_[1]) +
           static_cast<double>(kinds_[1].left) * mean(kinds_[1], kinds_[0]);
}

void TimeLeft::show(const std::string& line, bool now) {
    const HostTime time = clock_.now();
    if (!on_terminal_ && !now && time < next_) return;
    next_ = time + kLineEvery;
    if (on_terminal_)
        fmt::print(stderr, "\r\x1b[2K{}", line);
    else
        fmt::print(stderr, "{}\n", line);
    std::fflush(stderr);
}

}  // namespace foverig::sweep
