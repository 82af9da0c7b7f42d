#include "devices/fusion/head_fusion.h"

#include <algorithm>
#include <cmath>

#include "devices/fusion/rotation.h"

namespace foverig {
namespace {

constexpr double kSampleInterval_s = 1e-3;
constexpr std::size_t kSlopeSamples = 12;  // Savitzky-Golay length of LibOVR (3.1)
constexpr dvec3 kUp{0, 1, 0};

// The shortest rotation that takes unit `from` to unit `to`, as a rotation vector.
dvec3 rotation_between(const dvec3& from, const dvec3& to) {
    const dvec3 axis = glm::cross(from, to);
    const double sine = glm::length(axis);
    const double cosine = glm::dot(from, to);
    if (sine > 1e-12) return axis * (std::atan2(sine, cosine) / sine);
    return cosine > 0 ? dvec3(0) : dvec3(3.14159265358979323846, 0, 0);  // upside down: about x
}

}  // namespace

HeadFusion::HeadFusion(const HeadFusionConfig& config)
    : config_(config),
      bias_(config.bias),
      gains_({.end_gain_per_s = config.tilt_gain_per_s,
              .offset_sigma_rad_s = config.offset_sigma_rad_s,
              .walk_rad_s_sqrt_s = config.bias.walk_rad_s_sqrt_s,
              .response_s = config.accel_time_constant_s,
              .learns_offset = config.auto_bias}) {}

void HeadFusion::add(const ImuSample& sample) {
    if (!started_) {
        start(sample);
        return;
    }
    const Nanoseconds step = sample.device_time - newest_.device_time;
    if (step <= Nanoseconds{0}) return;
    const bool lost = step > config_.max_gap;
    const double dt_s = lost ? kSampleInterval_s : to_seconds(step);
    if (lost) {
        // Where the head went meanwhile is unknown; tilt is found again fast, yaw is kept.
        lost_track_ = true;
        gravity_s_ = 0;
        gains_.forget_tilt();
        felt_.reset();
        recent_.clear();
    } else {
        integrate(sample, dt_s);
    }
    if (config_.auto_bias &&
        bias_.add(sample.gyro_rad_s, sample.accel_m_s2, sample.temperature_c, dt_s)) {
        offset_by_gravity_rad_s_ = dvec3(0);
        gains_.offset_told();
    }
    rate_rad_s_ = sample.gyro_rad_s - offset_rad_s(sample.temperature_c);
    newest_ = sample;
    remember_rate(sample);
    correct_tilt(sample.accel_m_s2, dt_s);
}

void HeadFusion::start(const ImuSample& sample) {
    started_ = true;
    newest_ = sample;
    rate_rad_s_ = sample.gyro_rad_s;
    world_from_head_ = exp_map(config_.initial_yaw_rad * kUp);
    remember_rate(sample);
    correct_tilt(sample.accel_m_s2, kSampleInterval_s);
}

void HeadFusion::integrate(const ImuSample& sample, double dt_s) {
    const dvec3 rate_rad_s = sample.gyro_rad_s - offset_rad_s(sample.temperature_c);
    // Over missing samples the last rate goes on; only the last interval knows both its ends.
    const double known_s = std::min(dt_s, 1.5 * kSampleInterval_s);
    world_from_head_ = world_from_head_ * exp_map(rate_rad_s_ * (dt_s - known_s)) *
                       exp_map(rotation_of_rates(rate_rad_s_, rate_rad_s, known_s));
    world_from_head_ = glm::normalize(world_from_head_);
}

bool HeadFusion::near_gravity(const dvec3& force_m_s2) const {
    return std::abs(glm::length(force_m_s2) - kGravity_m_s2) < config_.max_gravity_error_m_s2;
}

// The sensor sits on a lever from the neck, and a turning head pulls it along. The mean of that
// acceleration over any time is the change of its velocity, which the gyro tells without delay; so
// the force is the mean over that time too.
void HeadFusion::sense_gravity(const dvec3& accel_m_s2, double dt_s) {
    const dvec3 lever_m = config_.eyes_from_neck_m + config_.sensor_from_eyes_m;
    const Felt now{world_from_head_ * accel_m_s2,
                   world_from_head_ * glm::cross(rate_rad_s_, lever_m)};
    const Felt before = felt_.value_or(now);
    felt_ = now;
    const dvec3 force_m_s2 = 0.5 * (before.force_m_s2 + now.force_m_s2) -
                             (now.velocity_m_s - before.velocity_m_s) / dt_s;
    gravity_s_ += dt_s;
    // At first a plain mean.
    const double weight =
        std::max(dt_s / gravity_s_, -std::expm1(-dt_s / config_.accel_time_constant_s));
    gravity_world_m_s2_ = glm::mix(gravity_world_m_s2_, force_m_s2, std::min(1.0, weight));
}

void HeadFusion::correct_tilt(const dvec3& accel_m_s2, double dt_s) {
    if (!std::isfinite(glm::length(accel_m_s2))) return;
    sense_gravity(accel_m_s2, dt_s);
    gains_.pass(dt_s);
    // The mean is judged and not each sample: taking only those samples of a turn that happen to be
    // as long as gravity would tilt the mean.
    if (!near_gravity(gravity_world_m_s2_)) return;
    const double rate_rad_s = glm::length(rate_rad_s_);
    const bool still = near_gravity(accel_m_s2) && rate_rad_s < config_.max_still_rate_rad_s;
    // The first samples of a head at rest say where up is; later it is a pull, strong at first. A
    // fast turn's own forces pull too.
    const bool first = still && gravity_s_ <= config_.accel_time_constant_s;
    const dvec3 error = rotation_between(glm::normalize(gravity_world_m_s2_), kUp);
    const TiltGains::Shares shares =
        first ? gains_.believe()
              : gains_.pull(error, dt_s, rate_rad_s <= config_.max_teaching_rate_rad_s);
    offset_by_gravity_rad_s_ -= shares.offset_per_s * (glm::conjugate(world_from_head_) * error);
    const dquat step = exp_map(error * shares.tilt);
    world_from_head_ = glm::normalize(step * world_from_head_);
    gravity_world_m_s2_ = step * gravity_world_m_s2_;
    felt_ = Felt{step * felt_->force_m_s2, step * felt_->velocity_m_s};
    if (gravity_s_ > 1) lost_track_ = false;
}

void HeadFusion::remember_rate(const ImuSample& sample) {
    if (sample.gap) recent_.clear();
    recent_.push_back({sample.device_time, sample.gyro_rad_s});
    if (recent_.size() > kSlopeSamples) recent_.pop_front();
}

// Least-squares slope of the last rates: the first-order Savitzky-Golay derivative, for any
// spacing.
dvec3 HeadFusion::angular_acceleration_rad_s2() const {
    if (recent_.size() < kSlopeSamples) return dvec3(0);
    double mean_s = 0;
    for (const Rate& r : recent_)
        mean_s += to_seconds(r.time - newest_.device_time) / static_cast<double>(kSlopeSamples);
    double variance = 0;
    dvec3 covariance(0);
    for (const Rate& r : recent_) {
        const double t_s = to_seconds(r.time - newest_.device_time) - mean_s;
        variance += t_s * t_s;
        covariance += t_s * r.rad_s;
    }
    return covariance / variance;
}

Pose HeadFusion::at(HostTime time) const {
    Pose pose;
    pose.time = time;
    if (!started_) {
        pose.stale = true;
        return pose;
    }
    const Nanoseconds ahead = time - newest_.host_time;
    const double dt_s =
        to_seconds(std::clamp(ahead, -config_.max_prediction, config_.max_prediction));
    dvec3 end_rate_rad_s = rate_rad_s_;
    if (config_.predictor == Predictor::constant_acceleration)
        end_rate_rad_s += dt_s * angular_acceleration_rad_s2();
    const dvec3 turn = config_.predictor == Predictor::none
                           ? dvec3(0)
                           : rotation_of_rates(rate_rad_s_, end_rate_rad_s, dt_s);
    pose.world_from_head = glm::normalize(world_from_head_ * exp_map(turn));
    pose.position_m = pose.world_from_head * config_.eyes_from_neck_m - config_.eyes_from_neck_m;
    pose.angular_velocity_rad_s = end_rate_rad_s;
    pose.stale = ahead > config_.max_prediction || lost_track_;
    return pose;
}

}  // namespace foverig
