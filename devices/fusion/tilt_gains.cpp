#include "devices/fusion/tilt_gains.h"

#include <algorithm>

namespace foverig {
namespace {

constexpr double kUnknownTilt_rad = 0.5;
// Own choices: over how long a sway is watched, and how long it pulls one way.
constexpr double kSwayMemory_s = 1.0, kSwayTime_s = 0.5;

double squared(double x) {
    return x * x;
}

}  // namespace

// In those units the gains of a filter that runs on are the covariances tilt_tilt and tilt_offset
// themselves. They end where
//   tilt_walk = tilt_tilt^2 - 2 tilt_offset,  offset_walk = tilt_offset^2  and
//   offset_offset = tilt_tilt tilt_offset.
TiltGains::TiltGains(const TiltGainsConfig& config)
    : config_(config),
      offset_scale_(0.25 * squared(config.end_gain_per_s) / config.walk_rad_s_sqrt_s) {
    tilt_walk_ = 0.5 * squared(config.end_gain_per_s);
    if (config.learns_offset) {
        offset_walk_ = squared(0.25 * squared(config.end_gain_per_s));
        offset_offset_ = squared(offset_scale_ * config.offset_sigma_rad_s);
    }
    forget_tilt();
}

void TiltGains::forget_tilt() {
    tilt_tilt_ = squared(offset_scale_ * kUnknownTilt_rad);
    tilt_offset_ = 0;
    since_s_ = 0;
    mean_error_rad_.reset();
    sway_rad2_ = 0;
}

void TiltGains::offset_told() {
    const double end_per_s2 = 0.25 * squared(config_.end_gain_per_s);
    offset_offset_ = std::min(offset_offset_, config_.end_gain_per_s * end_per_s2);
    tilt_offset_ = std::min(tilt_offset_, end_per_s2);
}

void TiltGains::pass(double dt_s) {
    since_s_ += dt_s;
    tilt_tilt_ += dt_s * (2 * tilt_offset_ + dt_s * offset_offset_ + tilt_walk_);
    tilt_offset_ += dt_s * offset_offset_;
    offset_offset_ += dt_s * offset_walk_;
}

TiltGains::Shares TiltGains::believe() {
    tilt_tilt_ = 1 / since_s_;
    tilt_offset_ = 0;
    mean_error_rad_ = dvec3(0);
    return {.tilt = 1};
}

/// Of one sample: the density that the end's gains imply, and a sway's.
double TiltGains::noise_of(const dvec3& error_rad, double dt_s) {
    const double share = dt_s / std::min(since_s_, kSwayMemory_s);
    const dvec3 off = error_rad - mean_error_rad_.value_or(error_rad);
    mean_error_rad_ = error_rad - (1 - share) * off;
    sway_rad2_ += share * (glm::dot(off, off) - sway_rad2_);
    return (1 + 2 * kSwayTime_s * squared(offset_scale_) * sway_rad2_) / dt_s;
}

TiltGains::Shares TiltGains::pull(const dvec3& error_rad, double dt_s, bool teaches) {
    const double noise = noise_of(error_rad, dt_s);
    const double spread = tilt_tilt_ + noise;
    const double fastest = std::min(1.0, dt_s / config_.response_s);
    const double least = std::min(1.0, dt_s * config_.end_gain_per_s);
    Shares shares;
    if (teaches && config_.learns_offset) {
        shares.tilt = std::min(tilt_tilt_ / spread, fastest);
        shares.offset_per_s = tilt_offset_ / spread;
    } else {
        shares.tilt = std::min(dt_s / (since_s_ + config_.response_s), fastest);
    }
    shares.tilt = std::max(shares.tilt, least);
    correct(shares, noise);
    *mean_error_rad_ -= shares.tilt * error_rad;
    return shares;
}

// Joseph's form, which holds for any gain.
void TiltGains::correct(const Shares& shares, double noise) {
    const double left = 1 - shares.tilt, by = shares.offset_per_s;
    const double spread = tilt_tilt_ + noise;
    offset_offset_ += by * (by * spread - 2 * tilt_offset_);
    tilt_offset_ = left * (tilt_offset_ - by * tilt_tilt_) + shares.tilt * by * noise;
    tilt_tilt_ = left * left * tilt_tilt_ + shares.tilt * shares.tilt * noise;
}

}  // namespace foverig
