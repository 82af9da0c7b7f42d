#include "devices/display/latency_tester.h"

#include <algorithm>
#include <cstdlib>

namespace foverig {
namespace {

constexpr int kGreyTolerance = 10;
constexpr int kCodes = kLatencyLevels - 1;
constexpr std::size_t kPostPresentWindow = 12;
constexpr std::size_t kPostPresentMinimum = 4;
constexpr Nanoseconds kLongestPostPresent{100'000'000};
constexpr Nanoseconds kForgetAfter{150'000'000};  // OVR05 starts again after 150 ms without a match
constexpr Nanoseconds kClockError{1'000'000};     // a submit just before vsync may map after it

}  // namespace

std::optional<int> level_of_grey(std::uint8_t grey) {
    for (int i = 0; i < kLatencyLevels; ++i) {
        if (std::abs(int{grey} - int{grey_of_level(i)}) < kGreyTolerance) return i;
    }
    return std::nullopt;
}

std::uint8_t LatencyTester::mark(const LatencyMark& mark) {
    const int level = 1 + static_cast<int>(marks_ % kCodes);
    pending_.push_back({level, marks_++, mark, false});
    // A level says which of the last seven frames it was; an older one could not be told apart.
    if (pending_.size() > kCodes) pending_.pop_front();
    return grey_of_level(level);
}

LatencyTester::Pending* LatencyTester::find(int level, HostTime scan_out) {
    for (Pending& p : pending_) {
        const Nanoseconds age = scan_out - p.mark.submit;
        if (p.level == level && age >= -kClockError && age < kForgetAfter) return &p;
    }
    return nullptr;
}

std::vector<LatencyReading> LatencyTester::read_back(std::uint16_t frame_count, HostTime scan_out,
                                                     std::uint8_t grey) {
    const std::optional<int> level = level_of_grey(grey);
    if (!level) {
        last_.reset();
        return {};
    }
    const bool follows = last_ &&
                         static_cast<std::uint16_t>(frame_count - last_->frame_count) == 1 &&
                         scan_out > last_->scan_out;
    Pending* const p = *level != kIdleLevel ? find(*level, scan_out) : nullptr;
    std::optional<LatencyReading> reading;
    if (p && !p->read) {
        // A frame that stays on the panel is read again; only its first scan-out is its latency,
        // and without the read before, this may not be the first.
        p->read = true;
        if (follows && last_->level != *level) {
            reading =
                LatencyReading{p->mark.frame_id, scan_out - p->mark.imu_sample,
                               scan_out - p->mark.submit, scan_out - p->mark.predicted_scan_out};
        }
    }
    std::vector<LatencyReading> confirmed;
    if (p && follows && last_->order && p->order >= *last_->order) {
        if (last_->unconfirmed) confirmed.push_back(*last_->unconfirmed);
        if (reading) confirmed.push_back(*reading);
        reading.reset();
    }
    last_ =
        Seen{frame_count, scan_out, *level, p ? std::optional(p->order) : std::nullopt, reading};
    for (const LatencyReading& r : confirmed) {
        if (r.submit_to_scan_out > kLongestPostPresent) continue;
        post_present_.push_back(std::max(r.submit_to_scan_out, Nanoseconds{0}));
        if (post_present_.size() > kPostPresentWindow) post_present_.pop_front();
    }
    return confirmed;
}

std::optional<Nanoseconds> LatencyTester::post_present() const {
    if (post_present_.size() < kPostPresentMinimum) return std::nullopt;
    std::vector<Nanoseconds> sorted(post_present_.begin(), post_present_.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
}

}  // namespace foverig
