#include "devices/display/vsync_clock.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace foverig {
namespace {

constexpr std::size_t kQueueFills = 8;  // swaps that may return at once although they will wait
constexpr std::size_t kLeastIntervals = 12;
constexpr double kRateTolerance = 0.03;  // GLFW rounds 59.94 Hz
constexpr double kEven = 0.10;           // quartiles of the intervals, of a period
constexpr std::size_t kRemembered = 256;
constexpr std::uint64_t kRefitEach = 16;
constexpr std::uint64_t kAhead = 12;  // vsyncs that may have been told already

Nanoseconds quantile(std::vector<Nanoseconds> values, double share) {
    const auto at = values.begin() +
                    static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

}  // namespace

VsyncClock::VsyncClock(double nominal_hz, HostTime first)
    : nominal_s_(1.0 / nominal_hz),
      lines_{{0, 0, first, nominal_s_}},
      error_(from_seconds(0.5 * nominal_s_)) {}

bool VsyncClock::judge(std::span<const HostTime> returns) {
    if (returns.size() < kQueueFills + kLeastIntervals + 1) return false;
    std::vector<Nanoseconds> intervals;
    for (std::size_t i = kQueueFills + 1; i < returns.size(); ++i)
        intervals.push_back(returns[i] - returns[i - 1]);
    const double median_s = to_seconds(quantile(intervals, 0.5));
    const double spread_s = to_seconds(quantile(intervals, 0.75) - quantile(intervals, 0.25));
    measured_ =
        std::abs(median_s / nominal_s_ - 1.0) < kRateTolerance && spread_s < kEven * nominal_s_;
    if (!measured_) return false;
    for (std::size_t i = kQueueFills; i < returns.size(); ++i) {
        const double periods = to_seconds(returns[i] - returns[kQueueFills]) / median_s;
        returns_.push_back({static_cast<std::uint64_t>(std::lround(periods)), returns[i]});
    }
    lines_ = {fitted()};
    lines_.front().from = 0;
    return true;
}

std::uint64_t VsyncClock::swapped(HostTime returned) {
    if (!measured_) return number_from(returned);
    const std::uint64_t number = std::max(nearest(returned), returns_.back().number + 1);
    returns_.push_back({number, returned});
    if (returns_.size() > kRemembered) returns_.pop_front();
    if (++swaps_ % kRefitEach != 0) return number;
    lines_.push_back(fitted());
    if (lines_.size() > 2) lines_.pop_front();
    return number;
}

// Least squares for the period, the earliest return for the phase.
VsyncClock::Line VsyncClock::fitted() {
    const Return& base = returns_.front();
    double sum_n = 0, sum_t = 0, sum_nn = 0, sum_nt = 0;
    for (const Return& r : returns_) {
        const auto n = static_cast<double>(r.number - base.number);
        const double t = to_seconds(r.at - base.at);
        sum_n += n, sum_t += t, sum_nn += n * n, sum_nt += n * t;
    }
    const auto count = static_cast<double>(returns_.size());
    const double slope = (count * sum_nt - sum_n * sum_t) / (count * sum_nn - sum_n * sum_n);
    const double period_s =
        std::clamp(slope, nominal_s_ * (1.0 - kRateTolerance), nominal_s_ * (1.0 + kRateTolerance));
    Line line{returns_.back().number + kAhead, base.number, base.at, period_s};
    std::vector<Nanoseconds> late;
    for (const Return& r : returns_) late.push_back(r.at - on(line, r.number));
    const Nanoseconds earliest = *std::min_element(late.begin(), late.end());
    line.at += earliest;
    error_ = quantile(std::move(late), 0.9) - earliest;
    return line;
}

Nanoseconds VsyncClock::error() const {
    return error_;
}

HostTime VsyncClock::on(const Line& line, std::uint64_t number) const {
    const auto steps = static_cast<double>(static_cast<std::int64_t>(number - line.number));
    return line.at + from_seconds(steps * line.period_s);
}

HostTime VsyncClock::vsync(std::uint64_t number) const {
    const Line& newest = lines_.back();
    return on(number >= newest.from ? newest : lines_.front(), number);
}

std::uint64_t VsyncClock::nearest(HostTime at) const {
    const std::uint64_t after = number_from(at);
    if (after == 0) return 0;
    return at - vsync(after - 1) < vsync(after) - at ? after - 1 : after;
}

std::uint64_t VsyncClock::number_from(HostTime at) const {
    const Line& line = lines_.back();
    const double periods =
        static_cast<double>(line.number) + to_seconds(at - line.at) / line.period_s;
    auto number = static_cast<std::uint64_t>(std::max(0.0, std::floor(periods) - 2.0));
    while (vsync(number) < at) ++number;
    return number;
}

}  // namespace foverig
