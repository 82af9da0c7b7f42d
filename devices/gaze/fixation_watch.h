#pragma once
// Whether an eye rests: a velocity threshold (I-VT, DEVICES.md 4.4) on means, so that the noise of
// single samples is not taken for speed.
#include <deque>

#include "devices/gaze_angles.h"
#include "devices/time.h"

namespace foverig::gaze {

class FixationWatch {
  public:
    struct Config {
        double fixation_deg_s = 30.0;     ///< between the means of the window's two halves
        Nanoseconds window{150'000'000};  ///< without a gap; I-VT drops fixations below 60 ms
    };

    explicit FixationWatch(const Config& config) : config_(config) {}

    /// In order of time.
    void add(GazeTime time, const dvec3& direction);
    /// A blink or a lost eye: what was seen before does not count.
    void lost() { seen_.clear(); }
    bool rests() const;

  private:
    struct Seen {
        GazeTime time;
        dvec3 direction;
    };

    Config config_;
    std::deque<Seen> seen_;  // the first one may be older than the window
};

inline void FixationWatch::add(GazeTime time, const dvec3& direction) {
    seen_.push_back({time, direction});
    while (seen_.size() > 2 && time - seen_[1].time >= config_.window) seen_.pop_front();
}

inline bool FixationWatch::rests() const {
    if (seen_.size() < 4 || seen_.back().time - seen_.front().time < config_.window) return false;
    const std::size_t half = seen_.size() / 2;
    dvec3 first(0.0), second(0.0);
    for (std::size_t i = 0; i < seen_.size(); ++i)
        (i < half ? first : second) += seen_[i].direction;
    const double half_s = 0.5 * to_seconds(seen_.back().time - seen_.front().time);
    return angle_between_deg(first, second) < config_.fixation_deg_s * half_s;
}

}  // namespace foverig::gaze
