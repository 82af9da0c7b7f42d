#include "devices/fusion/gyro_bias.h"

#include <cmath>

namespace foverig {
namespace {

constexpr double kLikely_sigma = 4.0;  // beyond: one of the two moments was a steady turn

double largest(const dvec3& v) {
    return glm::max(glm::max(std::abs(v.x), std::abs(v.y)), std::abs(v.z));
}

}  // namespace

bool GyroBias::add(const dvec3& gyro_rad_s, const dvec3& accel_m_s2, double temperature_c,
                   double dt_s) {
    time_s_ += dt_s;
    smooth_ = samples_ == 0 ? gyro_rad_s : glm::mix(smooth_, gyro_rad_s, config_.smoothing);
    const bool moves = largest(smooth_) >= config_.max_rate_rad_s ||
                       (samples_ > 0 && largest(smooth_ - mean_) >= config_.max_deviation_rad_s);
    if (moves) {
        const bool told = still_s_ > config_.partial_s && adopt_if_gravity_was_still();
        restart();
        return told;
    }
    ++samples_;
    mean_ += (gyro_rad_s - mean_) / static_cast<double>(samples_);
    mean_temperature_c_ += (temperature_c - mean_temperature_c_) / static_cast<double>(samples_);
    const dvec3 accel_step_m_s2 = accel_m_s2 - accel_mean_m_s2_;
    accel_mean_m_s2_ += accel_step_m_s2 / static_cast<double>(samples_);
    accel_squares_ += accel_step_m_s2 * (accel_m_s2 - accel_mean_m_s2_);
    still_s_ += dt_s;
    if (still_s_ < config_.full_s) return false;
    const bool told = adopt_if_gravity_was_still();
    restart();
    return told;
}

bool GyroBias::adopt_if_gravity_was_still() {
    const double limit = config_.max_accel_deviation_m_s2;
    if (largest(accel_squares_) > samples_ * limit * limit) return false;
    const Moment now{mean_, mean_temperature_c_, time_s_};
    if (known_) learn_slope(now);
    learnt_ = now;
    known_ = true;
    return true;
}

void GyroBias::learn_slope(const Moment& later) {
    const double warmth_c = later.temperature_c - learnt_.temperature_c;
    const double variance =
        2 * config_.mean_sigma_rad_s * config_.mean_sigma_rad_s +
        config_.walk_rad_s_sqrt_s * config_.walk_rad_s_sqrt_s * (later.time_s - learnt_.time_s);
    const dvec3 gained_rad_s = later.rad_s - learnt_.rad_s;
    const double by_slope_rad_s = warmth_c * config_.slope_sigma_rad_s_c;
    if (largest(gained_rad_s) >
        kLikely_sigma * std::sqrt(variance + by_slope_rad_s * by_slope_rad_s)) {
        return;
    }
    slope_sum_ += warmth_c / variance * gained_rad_s;
    slope_information_ += warmth_c * warmth_c / variance;
}

dvec3 GyroBias::slope_rad_s_c() const {
    const double sigma = config_.slope_sigma_rad_s_c;
    return slope_sum_ * (sigma * sigma / (1 + slope_information_ * sigma * sigma));
}

void GyroBias::restart() {
    samples_ = 0;
    mean_ = accel_mean_m_s2_ = accel_squares_ = dvec3(0);
    mean_temperature_c_ = 0;
    still_s_ = 0;
}

}  // namespace foverig
