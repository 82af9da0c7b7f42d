#include "rig/session/pacing.h"

#include <algorithm>
#include <vector>

namespace foverig {

Pacing::Pacing(const std::string& kind, const Display& display)
    : waits_(kind == "vsync"), display_(display) {}

HostTime Pacing::wake_up(HostTime now) const {
    // A display that paces has just let the last frame go, at a VSync.
    const bool paced = display_.vsync_knowledge().source == VsyncKnowledge::Source::display;
    if (!waits_ || paced) return now;
    return display_.next_vsync(last_begin_ ? std::max(now, *last_begin_ + Nanoseconds(1)) : now);
}

HostTime Pacing::aimed_vsync(HostTime begin) const {
    return display_.next_vsync(begin + Nanoseconds(1));
}

HostTime Pacing::expected_vsync(HostTime begin) const {
    if (recent_.empty()) return aimed_vsync(begin);
    std::vector<Nanoseconds> sorted(recent_.begin(), recent_.end());
    std::sort(sorted.begin(), sorted.end());
    return std::max(aimed_vsync(begin), display_.next_vsync(begin + sorted[sorted.size() / 2]));
}

void Pacing::frame_done(HostTime begin, HostTime present) {
    last_begin_ = begin;
    recent_.push_back(present - begin);
    if (recent_.size() > kRemembered) recent_.pop_front();
}

}  // namespace foverig
