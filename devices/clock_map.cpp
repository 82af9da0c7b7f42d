#include "devices/clock_map.h"

#include <algorithm>
#include <cmath>

namespace foverig {

void SkewTracker::reset() {
    ready_ = false;
    minima_.clear();
    open_.reset();
    slope_ = 0;
    residual_ns_ = 0;
    ++resets_;
}

void SkewTracker::start(const Point& p) {
    minima_.clear();
    open_ = p;
    window_start_ns_ = p.device_ns;
    fitted_ = before_ = now_ = p;
    slope_ = 0;
    residual_ns_ = 0;
    ready_ = true;
}

double SkewTracker::target(std::int64_t device_ns) const {
    return fitted_.skew_ns + slope_ * static_cast<double>(device_ns - fitted_.device_ns);
}

void SkewTracker::update(std::int64_t device_ns, std::int64_t arrival_ns) {
    if (!ready_) {
        origin_host_ns_ = arrival_ns;
        origin_device_ns_ = device_ns;
        start({device_ns, 0});
        return;
    }
    const auto relative = (arrival_ns - origin_host_ns_) - (device_ns - origin_device_ns_);
    const Point p{device_ns, static_cast<double>(relative)};
    // Nothing arrives before it was sent: far below the envelope means that a clock was set.
    if (p.skew_ns < target(device_ns) - static_cast<double>(config_.jump.count())) {
        start(p);
        ++resets_;
        return;
    }
    if (device_ns - window_start_ns_ >= config_.window.count()) {
        close_window();
        window_start_ns_ = device_ns;
    }
    if (!open_ || p.skew_ns <= open_->skew_ns) open_ = p;
    if (p.skew_ns < target(device_ns)) fitted_ = p;
    if (device_ns <= now_.device_ns) return;

    before_ = now_;
    const auto step_ns = static_cast<double>(device_ns - now_.device_ns);
    const double wish = target(device_ns) - now_.skew_ns;
    const double limit = config_.max_slew * step_ns;
    now_ = {device_ns, now_.skew_ns + std::clamp(wish, -limit, limit)};
}

void SkewTracker::close_window() {
    if (!open_) return;
    const Point closed = *open_;
    open_.reset();
    // A whole window far above: the device's clock went back. A stalled host looks the same, and is
    // put right at once by the first packet that is on time.
    if (closed.skew_ns > target(closed.device_ns) + static_cast<double>(config_.jump.count())) {
        start(closed);
        ++resets_;
        return;
    }
    minima_.push_back(closed);
    if (minima_.size() > config_.windows) (void)minima_.pop_front();
    fit();
}

// The line under all points that minimises the sum of vertical distances is the edge of their lower
// convex hull above which their mean abscissa lies.
void SkewTracker::fit() {
    points_.reserve(config_.windows);
    hull_.reserve(config_.windows);
    points_.clear();
    for (std::size_t i = 0; i < minima_.size(); ++i) points_.push_back(minima_[i]);
    std::sort(points_.begin(), points_.end(), [](const Point& a, const Point& b) {
        return a.device_ns != b.device_ns ? a.device_ns < b.device_ns : a.skew_ns < b.skew_ns;
    });
    const std::int64_t first_ns = points_.front().device_ns;
    const auto x = [&](const Point& p) { return static_cast<double>(p.device_ns - first_ns); };
    hull_.clear();
    double mean_x = 0;
    for (const Point& p : points_) {
        mean_x += x(p) / static_cast<double>(points_.size());
        if (!hull_.empty() && hull_.back().device_ns == p.device_ns) continue;
        while (hull_.size() >= 2) {
            const Point& a = hull_[hull_.size() - 2];
            const Point& b = hull_.back();
            const double turn =
                (x(b) - x(a)) * (p.skew_ns - a.skew_ns) - (b.skew_ns - a.skew_ns) * (x(p) - x(a));
            if (turn > 0) break;
            hull_.pop_back();
        }
        hull_.push_back(p);
    }
    constexpr std::size_t kEnoughForSlope = 6;
    if (points_.size() < kEnoughForSlope || hull_.size() < 2) {
        fitted_ = *std::min_element(hull_.begin(), hull_.end(), [](const Point& a, const Point& b) {
            return a.skew_ns < b.skew_ns;
        });
        slope_ = 0;
    } else {
        std::size_t i = 1;
        while (i + 1 < hull_.size() && x(hull_[i]) < mean_x) ++i;
        fitted_ = hull_[i];
        slope_ = (hull_[i].skew_ns - hull_[i - 1].skew_ns) / (x(hull_[i]) - x(hull_[i - 1]));
        slope_ = std::clamp(slope_, -config_.max_drift, config_.max_drift);
    }
    double above_ns = 0;
    for (const Point& p : points_) above_ns += p.skew_ns - target(p.device_ns);
    residual_ns_ = std::llround(above_ns / static_cast<double>(points_.size()));
}

std::int64_t SkewTracker::to_host(std::int64_t device_ns) const {
    double skew_ns = 0;
    if (device_ns >= now_.device_ns) {
        skew_ns = now_.skew_ns + slope_ * static_cast<double>(device_ns - now_.device_ns);
    } else if (device_ns <= before_.device_ns) {
        skew_ns = before_.skew_ns + slope_ * static_cast<double>(device_ns - before_.device_ns);
    } else {
        const double share = static_cast<double>(device_ns - before_.device_ns) /
                             static_cast<double>(now_.device_ns - before_.device_ns);
        skew_ns = before_.skew_ns + share * (now_.skew_ns - before_.skew_ns);
    }
    return origin_host_ns_ + (device_ns - origin_device_ns_) + std::llround(skew_ns);
}

}  // namespace foverig
