#include "rig/governor/governor.h"

#include <algorithm>

#include "renderer/check.h"

namespace foverig::governor {
namespace {

constexpr int kMostPatience = 8;  // times what was asked for

}  // namespace

Governor::Governor(std::vector<double> setting_ms, const Limits& limits)
    : setting_ms_(std::move(setting_ms)), limits_(limits), patience_(limits.patience_frames) {
    RIG_CHECK(!setting_ms_.empty(), "a governor chooses among settings");
    while (setting_ + 1 < setting_ms_.size() && setting_ms_[setting_ + 1] <= limits_.limit_ms)
        ++setting_;
}

void Governor::go_to(std::size_t setting) {
    if (setting == setting_) return;
    went_up_ = setting > setting_;
    setting_ = setting;
    ++changes_;
    fresh_ = true;
    held_frames_ = 0;
    scales_.clear();
}

void Governor::go_down(double scale) {
    if (setting_ == 0) return;
    if (went_up_ && held_frames_ <= kMostPatience * patience_)
        patience_ = std::min(2 * patience_, kMostPatience * limits_.patience_frames);
    std::size_t lower = setting_ - 1;
    while (lower > 0 && setting_ms_[lower] * scale > limits_.limit_ms) --lower;
    go_to(lower);
}

void Governor::consider_going_up() {
    if (setting_ + 1 == setting_ms_.size() || static_cast<int>(scales_.size()) < patience_) return;
    const double worst = *std::max_element(scales_.begin(), scales_.end());
    if (setting_ms_[setting_ + 1] * worst <= limits_.limit_ms) go_to(setting_ + 1);
}

void Governor::frame_took(double ms) {
    ++held_frames_;
    if (fresh_) {
        fresh_ = false;
        return;
    }
    const double scale = ms / setting_ms_[setting_];
    scales_.push_back(scale);
    while (static_cast<int>(scales_.size()) > patience_) scales_.pop_front();
    if (ms > limits_.limit_ms) {
        go_down(scale);
        return;
    }
    if (held_frames_ % (kMostPatience * patience_) == 0)
        patience_ = std::max(patience_ / 2, limits_.patience_frames);
    consider_going_up();
}

}  // namespace foverig::governor
